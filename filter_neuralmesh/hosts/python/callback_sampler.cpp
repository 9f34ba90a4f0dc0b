// SPDX-License-Identifier: GPL-3.0-or-later
#include "callback_sampler.h"

#include "arrays.h"

namespace nb = nanobind;

namespace neuralmesh::python {
namespace {

class CallbackSampler : public Sampler {
public:
    CallbackSampler(nb::object draw, const Box &box, bool isFlat)
        : draw_(std::move(draw)), frame_(box), isFlat_(isFlat)
    {
        bounds_ = {frame_.toUnit(box.min), frame_.toUnit(box.max)};
    }
    ~CallbackSampler() override
    {
        const nb::gil_scoped_acquire gil;
        draw_.reset();
    }

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return bounds_; }
    bool isFlat() const override { return isFlat_; }

    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override
    {
        const nb::gil_scoped_acquire gil;
        samples = pointsOf(nb::cast<AnyArray>(draw_(random.bits(), count)));
        for (Point &sample : samples)
            sample = frame_.toUnit(sample);
    }

private:
    nb::object draw_;
    UnitFrame frame_;
    Box bounds_;
    bool isFlat_;
};

} // namespace

std::unique_ptr<Sampler> callbackSampler(nb::object draw, const Box &box, bool isFlat)
{
    return std::make_unique<CallbackSampler>(std::move(draw), box, isFlat);
}

} // namespace neuralmesh::python
