// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/point_survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "samplers/input_checks.h"

namespace neuralmesh {
namespace {

/// Records between two calls of the progress callback.
constexpr std::uint64_t blockSize = std::uint64_t(1) << 20;

/// Least and greatest number of each coordinate, as the file has them: not scaled yet.
template <class T> struct Extremes {
    T low[3];
    T high[3];
    bool allFinite = true;
};

/// The extremes of a block: the pass over the file, on which its whole speed depends.
template <class T, bool bigEndian>
void extend(Extremes<T> &extremes, const PointRecords &records, std::uint64_t begin,
            std::uint64_t end)
{
    const auto &fields = records.layout().coordinates;
    const std::size_t stride = records.layout().recordSize;
    const std::size_t offsets[3] = {fields[0].offset, fields[1].offset, fields[2].offset};
    Extremes<T> e = extremes; // in registers
    T nothing = 0;            // NaN once a number is not finite
    const unsigned char *record = records.record(begin);
    for (std::uint64_t i = begin; i < end; ++i, record += stride)
        for (int axis = 0; axis < 3; ++axis) {
            const T number = loadNumber<T>(record + offsets[axis], bigEndian);
            e.low[axis] = number < e.low[axis] ? number : e.low[axis];
            e.high[axis] = number > e.high[axis] ? number : e.high[axis];
            if constexpr (std::is_floating_point_v<T>)
                nothing += number - number;
        }
    e.allFinite = extremes.allFinite && nothing == 0;
    extremes = e;
}

void countNotFinite(PointSurvey &survey, const PointRecords &records, std::uint64_t begin,
                    std::uint64_t end)
{
    for (std::uint64_t i = begin; i < end; ++i)
        if (!isFinite(records.point(i)) && survey.notFinite++ == 0)
            survey.firstNotFinite = i;
}

template <class T> PointSurvey surveyOfType(const PointRecords &records, const Progress &progress)
{
    PointSurvey survey;
    Extremes<T> extremes;
    std::fill_n(extremes.low, 3, std::numeric_limits<T>::max());
    std::fill_n(extremes.high, 3, std::numeric_limits<T>::lowest());
    for (std::uint64_t begin = 0; begin < records.count(); begin += blockSize) {
        const std::uint64_t end = std::min(begin + blockSize, records.count());
        report(progress, static_cast<double>(begin) / static_cast<double>(records.count()),
               "Reading the file");
        extremes.allFinite = true;
        if (records.layout().bigEndian)
            extend<T, true>(extremes, records, begin, end);
        else
            extend<T, false>(extremes, records, begin, end);
        if (!extremes.allFinite)
            countNotFinite(survey, records, begin, end);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const CoordinateField &field = records.layout().coordinates[static_cast<std::size_t>(axis)];
        survey.bounds.min[axis] = extremes.low[axis] * field.scale + field.shift;
        survey.bounds.max[axis] = extremes.high[axis] * field.scale + field.shift;
    }
    return survey;
}

/// Where x, y and z are of different types: rare, so it need not be fast.
PointSurvey surveyOfMixedTypes(const PointRecords &records, const Progress &progress)
{
    PointSurvey survey;
    for (std::uint64_t i = 0; i < records.count(); ++i) {
        if (i % blockSize == 0)
            report(progress, static_cast<double>(i) / static_cast<double>(records.count()),
                   "Reading the file");
        survey.bounds.Add(records.point(i));
    }
    countNotFinite(survey, records, 0, records.count());
    return survey;
}

} // namespace

PointSurvey surveyPoints(const PointRecords &records, const Progress &progress)
{
    const auto &fields = records.layout().coordinates;
    if (fields[0].type != fields[1].type || fields[0].type != fields[2].type)
        return surveyOfMixedTypes(records, progress);
    switch (fields[0].type) {
    case NumberType::int32: return surveyOfType<std::int32_t>(records, progress);
    case NumberType::float32: return surveyOfType<float>(records, progress);
    default: return surveyOfType<double>(records, progress);
    }
}

} // namespace neuralmesh
