// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/signal_counters.h"

#include <cassert>

namespace neuralmesh {
namespace {

constexpr double largestUnit = 1e100;

} // namespace

void SignalCounters::insert(VertexId id, double value)
{
    assert(!contains(id));
    if (id >= places_.size()) {
        places_.resize(static_cast<std::size_t>(id) + 1, nowhere);
        stored_.resize(static_cast<std::size_t>(id) + 1, 0);
    }
    stored_[id] = value * unit_;
    heap_.push_back(id);
    places_[id] = static_cast<Place>(heap_.size() - 1);
    siftUp(places_[id]);
}

void SignalCounters::erase(VertexId id)
{
    assert(contains(id));
    const Place place = places_[id];
    places_[id] = nowhere;
    const VertexId last = heap_.back();
    heap_.pop_back();
    if (last == id)
        return;
    put(place, last);
    siftUp(place);
    siftDown(places_[last]);
}

void SignalCounters::set(VertexId id, double value)
{
    stored_[id] = value * unit_;
    siftUp(places_[id]);
    siftDown(places_[id]);
}

void SignalCounters::add(VertexId id, double amount)
{
    stored_[id] += amount * unit_;
    siftUp(places_[id]);
}

void SignalCounters::decay(double alpha)
{
    unit_ /= alpha;
    if (unit_ > largestUnit)
        rescale();
}

void SignalCounters::rescale()
{
    // Dividing by a positive number keeps the order, except that counters too small to be told
    // apart may become equal: then the heap has to be made anew.
    for (double &stored : stored_)
        stored /= unit_;
    unit_ = 1;
    for (auto place = static_cast<Place>(heap_.size() / 2); place-- > 0;)
        siftDown(place);
}

void SignalCounters::put(Place place, VertexId id)
{
    heap_[place] = id;
    places_[id] = place;
}

void SignalCounters::siftUp(Place place)
{
    const VertexId id = heap_[place];
    while (place > 0) {
        const Place parent = (place - 1) / 2;
        if (!isHigher(id, heap_[parent]))
            break;
        put(place, heap_[parent]);
        place = parent;
    }
    put(place, id);
}

void SignalCounters::siftDown(Place place)
{
    const VertexId id = heap_[place];
    const auto count = static_cast<Place>(heap_.size());
    for (Place child = 2 * place + 1; child < count; child = 2 * place + 1) {
        if (child + 1 < count && isHigher(heap_[child + 1], heap_[child]))
            ++child;
        if (!isHigher(heap_[child], id))
            break;
        put(place, heap_[child]);
        place = child;
    }
    put(place, id);
}

} // namespace neuralmesh
