// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_survey.h"

#include <algorithm>
#include <limits>

#include "samplers/input_checks.h"

namespace neuralmesh {
namespace {

/// Records between two calls of the progress callback.
constexpr std::uint64_t blockSize = std::uint64_t(1) << 18;

/// Least and greatest numbers of x, y and z, as the file has them: not scaled yet. Takes eight
/// points at a time, as one row of numbers, which becomes vector instructions: on these depends the
/// speed of the whole pass.
template <class T> class Extremes {
public:
    static constexpr std::size_t points = 8;
    static constexpr std::size_t lanes = 3 * points;

    Extremes()
    {
        std::fill_n(low_, lanes, std::numeric_limits<T>::max());
        std::fill_n(high_, lanes, std::numeric_limits<T>::lowest());
    }

    /// `rows` times eight points, x, y, z in turn, in the byte order of the machine.
    void add(const unsigned char *bytes, std::size_t rows)
    {
        Extremes e = *this; // in registers
        for (; rows > 0; --rows, bytes += lanes * sizeof(T))
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                T number;
                std::memcpy(&number, bytes + lane * sizeof(T), sizeof(T));
                e.low_[lane] = number < e.low_[lane] ? number : e.low_[lane];
                e.high_[lane] = number > e.high_[lane] ? number : e.high_[lane];
                e.nothing_[lane] += number - number;
            }
        *this = e;
    }

    T low(std::size_t axis) const
    {
        T least = low_[axis];
        for (std::size_t lane = axis; lane < lanes; lane += 3)
            least = std::min(least, low_[lane]);
        return least;
    }

    T high(std::size_t axis) const
    {
        T greatest = high_[axis];
        for (std::size_t lane = axis; lane < lanes; lane += 3)
            greatest = std::max(greatest, high_[lane]);
        return greatest;
    }

    /// Whether all numbers since the last call were finite.
    bool wereFinite()
    {
        const bool finite =
            std::all_of(nothing_, nothing_ + lanes, [](T nothing) { return nothing == 0; });
        std::fill_n(nothing_, lanes, T(0));
        return finite;
    }

private:
    T low_[lanes];
    T high_[lanes];
    T nothing_[lanes] = {}; ///< NaN once a number is not finite
};

/// Whether the records are nothing but x, y and z as the machine has them in memory.
template <class T> bool arePacked(const PointLayout &layout)
{
    return layout.recordSize == 3 * sizeof(T) && layout.bigEndian == hostIsBigEndian &&
           layout.coordinates[0].offset == 0 && layout.coordinates[1].offset == sizeof(T) &&
           layout.coordinates[2].offset == 2 * sizeof(T);
}

template <class T>
void extend(Extremes<T> &extremes, const PointRecords &records, std::uint64_t begin,
            std::uint64_t end)
{
    constexpr std::size_t points = Extremes<T>::points;
    const PointLayout &layout = records.layout();
    if (arePacked<T>(layout)) {
        extremes.add(records.record(begin), (end - begin) / points);
        begin += (end - begin) / points * points;
    }
    T row[Extremes<T>::lanes];
    for (; begin < end; begin += points) {
        for (std::size_t i = 0; i < points; ++i) {
            // The last row is filled up with the last record.
            const unsigned char *const record = records.record(std::min(begin + i, end - 1));
            for (std::size_t axis = 0; axis < 3; ++axis)
                row[3 * i + axis] =
                    loadNumber<T>(record + layout.coordinates[axis].offset, layout.bigEndian);
        }
        extremes.add(reinterpret_cast<const unsigned char *>(row), 1);
    }
}

void countNotFinite(PointSurvey &survey, const PointRecords &records, std::uint64_t begin,
                    std::uint64_t end)
{
    for (std::uint64_t i = begin; i < end; ++i)
        if (!isFinite(records.point(i)) && survey.notFinite++ == 0)
            survey.firstNotFinite = i;
}

/// Calls look(begin, end) for one block of records after the other, as long as there is time: at
/// the least for the first.
template <class Look>
void forEachBlock(PointSurvey &survey, const PointRecords &records, const Progress &progress,
                  const Look &look)
{
    const std::uint64_t count = records.count();
    while (survey.looked < count && !(survey.looked > 0 && progress.isTimeUp())) {
        report(progress, static_cast<double>(survey.looked) / static_cast<double>(count),
               "Reading the file");
        const std::uint64_t end = std::min(survey.looked + blockSize, count);
        look(survey.looked, end);
        survey.looked = end;
    }
}

template <class T> PointSurvey surveyOfType(const PointRecords &records, const Progress &progress)
{
    PointSurvey survey;
    Extremes<T> extremes;
    forEachBlock(survey, records, progress, [&](std::uint64_t begin, std::uint64_t end) {
        extend(extremes, records, begin, end);
        if (!extremes.wereFinite())
            countNotFinite(survey, records, begin, end);
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const CoordinateField &field = records.layout().coordinates[axis];
        const auto place = static_cast<int>(axis);
        survey.bounds.min[place] = extremes.low(axis) * field.scale + field.shift;
        survey.bounds.max[place] = extremes.high(axis) * field.scale + field.shift;
    }
    return survey;
}

/// Where x, y and z are of different types: rare, so it need not be fast.
PointSurvey surveyOfMixedTypes(const PointRecords &records, const Progress &progress)
{
    PointSurvey survey;
    forEachBlock(survey, records, progress, [&](std::uint64_t begin, std::uint64_t end) {
        for (std::uint64_t i = begin; i < end; ++i)
            survey.bounds.Add(records.point(i));
        countNotFinite(survey, records, begin, end);
    });
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
