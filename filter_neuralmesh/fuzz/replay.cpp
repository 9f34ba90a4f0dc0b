// SPDX-License-Identifier: GPL-3.0-or-later
// In libFuzzer's place, where there is only another compiler: feeds files, and all files of
// folders, to a fuzz target. After --mutate COUNT, it feeds so many blind changes of them instead.
//
// Exit codes: 0 all went well, 1 a promise was broken, 2 there is no such file.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "neuralmesh/random.h"

namespace {

namespace fs = std::filesystem;

struct Input {
    std::string name, content;
};

std::vector<Input> inputsOf(const fs::path &path)
{
    std::vector<fs::path> files;
    if (!fs::is_directory(path))
        files.push_back(path);
    else
        for (const fs::directory_entry &entry : fs::recursive_directory_iterator(path))
            if (entry.is_regular_file())
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Input> inputs;
    for (const fs::path &file : files) {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) {
            std::fprintf(stderr, "%s is not there.\n", file.string().c_str());
            std::exit(2);
        }
        inputs.push_back({file.string(), {std::istreambuf_iterator<char>(stream), {}}});
    }
    return inputs;
}

/// A few changes: bytes replaced, by any or by telling ones, blocks left out, doubled or taken from
/// another input.
std::string changed(std::string content, const std::string &other, neuralmesh::Random &random)
{
    static const std::string telling("\0\x01\x7f\x80\xff 0-9\n{(<>,'", 16);
    for (std::uint64_t changes = 1 + random.below(6); changes > 0; --changes) {
        const std::size_t place = random.below(content.size() + 1);
        const std::size_t length = random.below(16);
        switch (random.below(5)) {
        case 0: content.erase(place, length); break;
        case 1: content.insert(place, content.substr(place, length)); break;
        case 2: content.insert(place, other.substr(random.below(other.size() + 1), length)); break;
        case 3:
            if (place < content.size())
                content[place] = telling[random.below(telling.size())];
            break;
        default:
            if (place < content.size())
                content[place] = static_cast<char>(random.below(256));
        }
    }
    return content;
}

/// In a block of exactly their size, so that a sanitizer sees a read behind the end.
void feed(const std::string &content)
{
    const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[content.size()]);
    std::memcpy(exact.get(), content.data(), content.size());
    LLVMFuzzerTestOneInput(exact.get(), content.size());
}

/// What is fed is written beside the program first, as `last_input`: a crash leaves it there.
void feedChanges(const std::vector<Input> &inputs, int count)
{
    neuralmesh::Random random(1);
    const auto any = [&]() -> const Input & { return inputs[random.below(inputs.size())]; };
    for (int i = 0; i < count; ++i) {
        const std::string &other = any().content;
        const std::string content = changed(any().content, other, random);
        std::ofstream("last_input", std::ios::binary) << content;
        feed(content);
    }
}

} // namespace

int main(int argc, char **argv)
{
    int mutations = 0;
    std::vector<Input> inputs;
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--mutate") == 0 && i + 1 < argc)
            mutations = std::atoi(argv[++i]);
        else
            for (Input &input : inputsOf(argv[i]))
                inputs.push_back(std::move(input));
    if (inputs.empty())
        return 2;
    std::string name = "last_input";
    try {
        if (mutations > 0)
            feedChanges(inputs, mutations);
        else
            for (const Input &input : inputs) {
                name = input.name;
                feed(input.content);
            }
    } catch (const std::exception &broken) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), broken.what());
        return 1;
    }
    std::printf("%d inputs\n", mutations > 0 ? mutations : static_cast<int>(inputs.size()));
    return 0;
}
