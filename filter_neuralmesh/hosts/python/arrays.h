// SPDX-License-Identifier: GPL-3.0-or-later
// NumPy's arrays as the core's, and back.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <memory>
#include <vector>

#include "neuralmesh/attribute_transfer.h"
#include "neuralmesh/geometry.h"

namespace neuralmesh::python {

/// Of numbers, of any strides, on this machine's processor. Python sees to the type and the shape.
using AnyArray = nanobind::ndarray<nanobind::ro, nanobind::device::cpu>;

/// An array that a thread without the GIL may read and let go of.
class SharedArray {
public:
    explicit SharedArray(AnyArray array);
    const AnyArray &operator*() const { return *array_; }

private:
    std::shared_ptr<const AnyArray> array_;
};

/// Of what is no array but None, nothing.
std::shared_ptr<const SharedArray> optionalArray(const nanobind::object &array);

/// Copies n x 3 numbers of float32 or float64, whatever their strides. Needs no GIL.
std::vector<Point> pointsOf(const AnyArray &array);

/// Copies n numbers of float64.
std::vector<double> numbersOf(const AnyArray &array);

/// Copies n x 3 vertex numbers of int64, which are not negative and fit a VertexId.
std::vector<Corners> cornersOf(const AnyArray &array);

/// Copies n x 5 numbers of float64.
std::vector<AttributeValues> attributesOf(const AnyArray &array);

/// An n x 3 array that owns the vector: nothing is copied. Corners become int32.
nanobind::object arrayOf(std::vector<Point> points);
nanobind::object arrayOf(std::vector<Corners> corners);
/// An n x 5 array.
nanobind::object arrayOf(std::vector<AttributeValues> values);
/// One-dimensional.
nanobind::object arrayOf(std::vector<double> numbers);
nanobind::object arrayOf(std::vector<int> numbers);

} // namespace neuralmesh::python
