// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_file_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/portability.h"
#include "neuralmesh/sampler_errors.h"
#include "samplers/files/point_file_format.h"
#include "samplers/files/point_survey.h"
#include "samplers/input_checks.h"
#include "samplers/points/density_weights.h"
#include "samplers/points/distinct_points.h"

namespace neuralmesh {
namespace {

/// Bounds that a header claims are believed where no pilot point lies outside by more than this
/// share of their diagonal, and where the pilot points fill this share of it.
constexpr double boundsTolerance = 1e-3;
constexpr double leastFilled = 0.5;

/// Points drawn between two looks at whether the file has changed.
constexpr std::size_t pointsPerLook = 1 << 20;

/// The same while outliers are counted.
constexpr std::uint64_t pointsPerReport = 1 << 16;

/// Of so many points each is judged before the first is drawn, so that their outliers are counted.
constexpr std::uint64_t mostPointsJudged = 200000;

/// Draws until one is no outlier. Of places at most a fifth are outliers, but each may be repeated;
/// so many in a row do not happen in a file that stays as it was.
constexpr int mostDraws = 100000;

/// Records that are asked for before the first of them is read.
constexpr std::size_t readsAtOnce = 64;

const char *const changed = "the file was changed while it was being read.";

/// Uniform in [0, count), for files of more points too than Random::below() takes.
std::uint64_t randomIndex(Random &random, std::uint64_t count)
{
    if (count <= std::uint64_t(1) << 32)
        return random.below(count);
    const auto index = static_cast<std::uint64_t>(random.unit() * static_cast<double>(count));
    return std::min(index, count - 1);
}

std::vector<Point3> pilotOf(const PointRecords &records)
{
    return everyNth(records.count(), OutlierFilter::pilotPoints,
                    [&](std::uint64_t index) { return records.point(index); });
}

bool contains(const vcg::Box3d &box, const vcg::Box3d &other)
{
    return box.IsIn(other.min) && box.IsIn(other.max);
}

vcg::Box3d tolerated(vcg::Box3d claimed)
{
    claimed.Offset(boundsTolerance * claimed.Diag());
    return claimed;
}

/// Whether bounds that a header claims, which may be wrong or out of date, fit the points.
bool areCredible(const vcg::Box3d &claimed, const PointRecords &records)
{
    vcg::Box3d filled;
    for (const Point3 &point : pilotOf(records))
        filled.Add(point);
    return contains(tolerated(claimed), filled) && filled.Diag() >= leastFilled * claimed.Diag();
}

} // namespace

PointFileSampler::PointFileSampler(const std::string &path, const Progress &progress)
try : path_(path), file_(path), records_(file_.bytes(), readPointLayout(file_.bytes())) {
    setAsideOutliers(findWorldBounds(progress), progress);
    requireFourPoints(countDistinctPoints(4));
    std::vector<Point3> kept;
    for (const Point3 &point : pilotOf(records_))
        if (isToBeDrawn(point))
            kept.push_back(toUnit(frame_, point));
    isFlat_ = neuralmesh::isFlat(kept, left_.count);
    const auto pointAt = [&](std::uint64_t i) { return frame_.toUnit(toPlain(records_.point(i))); };
    order_ = OrderOfPoints(records_.count(), bounds(), pointAt);
    order_.weigh(
        weightsByDensity(order_.count(), [&](std::uint64_t i) { return pointAt(order_.at(i)); }));
    if (file_.hasChanged())
        throw InvalidInput(changed);
} catch (const InvalidInput &problem) {
    std::throw_with_nested(InvalidPointFile(path, problem.what()));
}

void PointFileSampler::setFrame(const vcg::Box3d &worldBounds)
{
    frame_ = frameOf(worldBounds);
    bounds_ = Box3(toUnit(frame_, worldBounds.min), toUnit(frame_, worldBounds.max));
}

/// Outliers may lie so far off that the rest is next to nothing in the frame of all. Whatever lies
/// out of the reach of the pilot points is one, also where a header does not know of it.
void PointFileSampler::setAsideOutliers(const vcg::Box3d &worldBounds, const Progress &progress)
{
    drawn_ = tolerated(worldBounds);
    filter_ = OutlierFilter::of(records_.count(),
                                [&](std::uint64_t index) { return records_.point(index); });
    if (!filter_.isActive()) {
        setFrame(worldBounds);
        return;
    }
    drawn_ = filter_.bounds();
    const bool areInReach = contains(drawn_, worldBounds);
    judgesEach_ = filter_.share() > 0 || records_.count() <= mostPointsJudged;
    const bool isCounted = records_.count() <= mostPointsJudged;
    if (isCounted || (!areInReach && !judgesEach_)) {
        countOutliers(progress);
        judgesEach_ = judgesEach_ && left_.count > 0;
    } else if (judgesEach_) {
        left_.share = filter_.share();
        left_.count = static_cast<std::uint64_t>(
            std::llround(left_.share * static_cast<double>(records_.count())));
        left_.isEstimate = true;
    }
    vcg::Box3d kept = drawn_;
    kept.Intersect(worldBounds);
    setFrame(areInReach && left_.count == 0 ? worldBounds : kept);
}

/// Where time is up, an estimate by the first of the points.
void PointFileSampler::countOutliers(const Progress &progress)
{
    std::uint64_t looked = 0;
    for (; looked < records_.count(); ++looked) {
        if (looked % pointsPerReport == 0) {
            report(progress, static_cast<double>(looked) / static_cast<double>(records_.count()),
                   "Counting isolated points");
            if (looked > 0 && progress.isTimeUp())
                break;
        }
        left_.count += isToBeDrawn(records_.point(looked)) ? 0 : 1;
    }
    left_.share = static_cast<double>(left_.count) / static_cast<double>(looked);
    left_.isEstimate = looked < records_.count();
    if (left_.isEstimate)
        left_.count = static_cast<std::uint64_t>(
            std::llround(left_.share * static_cast<double>(records_.count())));
}

bool PointFileSampler::isToBeDrawn(const Point3 &world) const
{
    return drawn_.IsIn(world) && !(judgesEach_ && filter_.isOutlier(world));
}

vcg::Box3d PointFileSampler::findWorldBounds(const Progress &progress)
{
    file_.expectRandomReads();
    const std::optional<vcg::Box3d> &claimed = records_.layout().claimedBounds;
    if (claimed && areCredible(*claimed, records_))
        return *claimed;
    file_.expectPass();
    const PointSurvey survey = surveyPoints(records_, progress);
    records_.keepFirst(survey.looked);
    file_.expectRandomReads();
    if (survey.notFinite > 0)
        refuseNotFinite(survey.notFinite, records_.count(), survey.firstNotFinite);
    return survey.bounds;
}

void PointFileSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    drawEach(
        random, [&](std::size_t) { return randomIndex(random, records_.count()); }, samples);
}

void PointFileSampler::drawStratified(Random &random, const Strata &strata,
                                      std::vector<Point> &samples) const
{
    samples.resize(strata.end - strata.first);
    drawEach(
        random, [&](std::size_t i) { return order_.draw(random, strata.first + i, strata.count); },
        samples);
}

/// The records index(0), index(1), ...
template <class Index>
void PointFileSampler::drawEach(Random &random, const Index &index,
                                std::vector<Point> &samples) const
{
    for (std::size_t begin = 0; begin < samples.size(); begin += pointsPerLook) {
        if (file_.hasChanged())
            throw InvalidPointFile(path_, changed);
        const std::size_t end = std::min(begin + pointsPerLook, samples.size());
        for (std::size_t i = begin; i < end; i += readsAtOnce)
            drawAtOnce(random, i, std::min(i + readsAtOnce, end), index, &samples[i]);
    }
}

/// Asks for all records before it reads the first: each lies on a page of its own, and the memory
/// answers several requests in hardly more time than one.
template <class Index>
void PointFileSampler::drawAtOnce(Random &random, std::size_t first, std::size_t end,
                                  const Index &index, Point *samples) const
{
    std::uint64_t indices[readsAtOnce];
    for (std::size_t i = first; i < end; ++i) {
        indices[i - first] = index(i);
        prefetch(records_.record(indices[i - first]));
    }
    for (std::size_t i = 0; i < end - first; ++i) {
        const Point3 world = records_.point(indices[i]);
        samples[i] = toPlain(toUnit(frame_, isToBeDrawn(world) ? world : drawAnother(random)));
    }
}

/// A file may be written to and have its time put back: no number of it is trusted to be finite,
/// and none to be one that is drawn.
Point3 PointFileSampler::drawAnother(Random &random) const
{
    for (int tries = 0; tries < mostDraws; ++tries) {
        const Point3 world = records_.point(randomIndex(random, records_.count()));
        if (!isFinite(world))
            break;
        if (isToBeDrawn(world))
            return world;
    }
    throw InvalidPointFile(path_, changed);
}

std::size_t PointFileSampler::pointCount() const
{
    return static_cast<std::size_t>(records_.count());
}

std::size_t PointFileSampler::countDistinctPoints(std::size_t enough) const
{
    DistinctPoints distinct(std::min(enough, pointCount()));
    for (std::uint64_t i = 0; i < records_.count() && distinct.size() < enough; ++i)
        if (const Point3 world = records_.point(i); isToBeDrawn(world))
            distinct.insert(world);
    return distinct.size();
}

} // namespace neuralmesh
