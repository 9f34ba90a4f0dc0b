// SPDX-License-Identifier: GPL-3.0-or-later
// Opens each point file named on the command line and draws from it; prints a line each: "accepted"
// or the sentence of the refusal. Used on broken files, under sanitizers too.
#include <cstdio>
#include <vector>

#include "neuralmesh/errors.h"
#include "neuralmesh/samplers.h"
#include "plugin/error_sentences.h"

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        try {
            const auto sampler = neuralmesh::pointFileSampler(argv[i]);
            neuralmesh::Random random(1);
            std::vector<neuralmesh::Point> samples;
            sampler->draw(random, 1000, samples);
            std::puts("accepted");
        } catch (const neuralmesh::InvalidInput &problem) {
            std::puts(sentenceFor(problem).c_str());
        }
    }
}
