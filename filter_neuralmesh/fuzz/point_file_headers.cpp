// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes as a point file: its header is read, and where it is one, every point.
#include "fuzz/choices.h"
#include "fuzz/fuzz_target.h"
#include "samplers/files/point_file_format.h"
#include "samplers/files/point_survey.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    using namespace neuralmesh;
    return fuzz::refusingOrNot([&] {
        const Bytes file{data, size};
        const PointRecords records(file, readPointLayout(file));
        const PointSurvey survey = surveyPoints(records);
        fuzz::require(survey.notFinite <= records.count(), "no more broken points than points");
    });
}
