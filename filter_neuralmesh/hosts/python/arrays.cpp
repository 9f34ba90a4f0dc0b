// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <array>

namespace nb = nanobind;

namespace neuralmesh::python {
namespace {

/// The rows of a two-dimensional array of `Value`, each given to `take` as a function of the
/// column.
template <class Value, class Take> void forEachRow(const AnyArray &array, const Take &take)
{
    const auto *row = static_cast<const Value *>(array.data());
    const std::int64_t down = array.stride(0), across = array.stride(1);
    for (std::size_t i = 0; i < array.shape(0); ++i, row += down)
        take([&](std::size_t column) { return row[static_cast<std::int64_t>(column) * across]; });
}

/// NumPy gets `data`, `columns` wide, and with it the vector.
template <class Value, class Item> nb::object handOver(std::vector<Item> items, std::size_t columns)
{
    auto owned = std::make_unique<std::vector<Item>>(std::move(items));
    // Two types of one size, signed and unsigned, may share memory.
    auto *data = reinterpret_cast<Value *>(owned->data());
    const std::size_t shape[2] = {owned->size(), columns};
    nb::capsule owner(owned.get(), [](void *pointer) noexcept {
        delete static_cast<std::vector<Item> *>(pointer);
    });
    owned.release();
    return nb::cast(nb::ndarray<nb::numpy, Value>(data, columns == 1 ? 1 : 2, shape, owner),
                    nb::rv_policy::reference);
}

} // namespace

SharedArray::SharedArray(AnyArray array)
    : array_(new AnyArray(std::move(array)), [](const AnyArray *pointer) {
          const nb::gil_scoped_acquire gil;
          delete pointer;
      })
{
}

std::shared_ptr<const SharedArray> optionalArray(const nb::object &array)
{
    if (array.is_none())
        return nullptr;
    return std::make_shared<const SharedArray>(nb::cast<AnyArray>(array));
}

std::vector<Point> pointsOf(const AnyArray &array)
{
    std::vector<Point> points;
    points.reserve(array.shape(0));
    const auto take = [&](const auto &at) {
        points.push_back({double(at(0)), double(at(1)), double(at(2))});
    };
    if (array.dtype() == nb::dtype<float>())
        forEachRow<float>(array, take);
    else
        forEachRow<double>(array, take);
    return points;
}

std::vector<double> numbersOf(const AnyArray &array)
{
    std::vector<double> numbers;
    numbers.reserve(array.shape(0));
    const auto *data = static_cast<const double *>(array.data());
    for (std::size_t i = 0; i < array.shape(0); ++i)
        numbers.push_back(data[static_cast<std::int64_t>(i) * array.stride(0)]);
    return numbers;
}

std::vector<Corners> cornersOf(const AnyArray &array)
{
    std::vector<Corners> corners;
    corners.reserve(array.shape(0));
    forEachRow<std::int64_t>(array, [&](const auto &at) {
        corners.push_back({VertexId(at(0)), VertexId(at(1)), VertexId(at(2))});
    });
    return corners;
}

std::vector<AttributeValues> attributesOf(const AnyArray &array)
{
    std::vector<AttributeValues> values;
    values.reserve(array.shape(0));
    forEachRow<double>(array, [&](const auto &at) {
        values.push_back({at(0), at(1), at(2), at(3), at(4)});
    });
    return values;
}

nb::object arrayOf(std::vector<Point> points)
{
    return handOver<double>(std::move(points), 3);
}

nb::object arrayOf(std::vector<Corners> corners)
{
    return handOver<std::int32_t>(std::move(corners), 3);
}

nb::object arrayOf(std::vector<AttributeValues> values)
{
    return handOver<double>(std::move(values), 5);
}

nb::object arrayOf(std::vector<double> numbers)
{
    return handOver<double>(std::move(numbers), 1);
}

nb::object arrayOf(std::vector<int> numbers)
{
    return handOver<std::int32_t>(std::move(numbers), 1);
}

} // namespace neuralmesh::python
