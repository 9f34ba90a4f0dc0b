// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_file_sampler.h"

#include <algorithm>

#include "core/portability.h"
#include "neuralmesh/sampler_errors.h"
#include "samplers/files/point_file_format.h"
#include "samplers/files/point_survey.h"
#include "samplers/input_checks.h"
#include "samplers/points/distinct_points.h"

namespace neuralmesh {
namespace {

/// Points from which outliers, flatness and claimed bounds are judged: as many as the outlier
/// filter looks at in a cloud in memory.
constexpr std::uint64_t pilotPoints = OutlierFilter::pilotPoints;

/// Bounds that a header claims are believed where no pilot point lies outside by more than this
/// share of their diagonal, and where the pilot points fill this share of it.
constexpr double boundsTolerance = 1e-3;
constexpr double leastFilled = 0.5;

/// Points drawn between two looks at whether the file has changed.
constexpr std::size_t pointsPerLook = 1 << 20;

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

/// Every n-th index below count, as many as asked for or all.
template <class Visit> void visitPilot(std::uint64_t count, const Visit &visit)
{
    const std::uint64_t chosen = std::min(count, pilotPoints);
    // No overflow: a mapped file holds fewer than 2^44 points.
    for (std::uint64_t i = 0; i < chosen; ++i)
        visit(i * count / chosen);
}

/// Whether bounds that a header claims, which may be wrong or out of date, fit the points.
bool areCredible(const vcg::Box3d &claimed, const PointRecords &records)
{
    vcg::Box3d pilot;
    visitPilot(records.count(), [&](std::uint64_t index) { pilot.Add(records.point(index)); });
    vcg::Box3d tolerated = claimed;
    tolerated.Offset(boundsTolerance * claimed.Diag());
    return tolerated.IsIn(pilot.min) && tolerated.IsIn(pilot.max) &&
           pilot.Diag() >= leastFilled * claimed.Diag();
}

} // namespace

PointFileSampler::PointFileSampler(const std::string &path, const Progress &progress)
try : path_(path), file_(path), records_(file_.bytes(), readPointLayout(file_.bytes())) {
    setFrame(findWorldBounds(progress));
    requireFourPoints(countDistinctPoints(4));
    std::vector<Point3> pilot = readPilot();
    if (const OutlierFilter filter(pilot, bounds_); filter.isActive()) {
        // Outliers may lie so far off that the rest is next to nothing in the frame of all.
        setFrame(toWorld(frame_, filter.bounds()));
        pilot = readPilot();
        outliers_.emplace(pilot, bounds_);
        pilot.erase(std::remove_if(pilot.begin(), pilot.end(),
                                   [&](const Point3 &p) { return outliers_->isOutlier(p); }),
                    pilot.end());
    }
    isFlat_ = neuralmesh::isFlat(pilot);
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

std::vector<Point3> PointFileSampler::readPilot() const
{
    std::vector<Point3> pilot;
    visitPilot(records_.count(), [&](std::uint64_t index) { pilot.push_back(unitPoint(index)); });
    return pilot;
}

vcg::Box3d PointFileSampler::findWorldBounds(const Progress &progress) const
{
    file_.expectRandomReads();
    const std::optional<vcg::Box3d> &claimed = records_.layout().claimedBounds;
    if (claimed && areCredible(*claimed, records_))
        return *claimed;
    file_.expectPass();
    const PointSurvey survey = surveyPoints(records_, progress);
    file_.expectRandomReads();
    if (survey.notFinite > 0)
        refuseNotFinite(survey.notFinite, records_.count(), survey.firstNotFinite);
    return survey.bounds;
}

void PointFileSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    for (std::size_t begin = 0; begin < count; begin += pointsPerLook) {
        if (file_.hasChanged())
            throw InvalidPointFile(path_, changed);
        const std::size_t end = std::min(begin + pointsPerLook, count);
        if (outliers_)
            for (std::size_t i = begin; i < end; ++i)
                samples[i] = toPlain(drawNoOutlier(random));
        else
            for (std::size_t i = begin; i < end; i += readsAtOnce)
                drawAtOnce(random, std::min(readsAtOnce, end - i), &samples[i]);
    }
}

/// Asks for all records before it reads the first: each lies on a page of its own, and the memory
/// answers several requests in hardly more time than one.
void PointFileSampler::drawAtOnce(Random &random, std::size_t count, Point *samples) const
{
    std::uint64_t indices[readsAtOnce];
    for (std::size_t i = 0; i < count; ++i) {
        indices[i] = randomIndex(random, records_.count());
        prefetch(records_.record(indices[i]));
    }
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = toPlain(unitPoint(indices[i]));
}

Point3 PointFileSampler::drawNoOutlier(Random &random) const
{
    Point3 sample;
    // At most a fifth are outliers: 64 in a row do not happen.
    for (int tries = 0; tries < 64; ++tries) {
        sample = unitPoint(randomIndex(random, records_.count()));
        if (!outliers_->isOutlier(sample))
            break;
    }
    return sample;
}

std::size_t PointFileSampler::pointCount() const
{
    return static_cast<std::size_t>(records_.count());
}

std::size_t PointFileSampler::countDistinctPoints(std::size_t enough) const
{
    DistinctPoints distinct(std::min(enough, pointCount()));
    for (std::uint64_t i = 0; i < records_.count() && distinct.size() < enough; ++i)
        distinct.insert(unitPoint(i));
    return distinct.size();
}

} // namespace neuralmesh
