// Work on all cores. What is computed never depends on how many there are: an item sees its index only.
#pragma once

#include <cstddef>
#include <functional>

namespace torrance {

/// Number of worker threads: the cores this process may run on, or TORRANCE_THREADS.
std::size_t workerCount();

/// Calls work(first, last) for the ranges [0, grain), [grain, 2 grain), ... of [0, count), in any order, on all
/// workers, which are started once and kept; returns when all are done. Calls may come from several threads and from
/// within `work`: a caller takes part in its own call. The first exception is rethrown here, and ranges that nobody has
/// begun by then are left out.
void parallelRanges(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work);

/// The same item by item: calls work(i) once for every i in [0, count), `grain` consecutive items at a time.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& work);

} // namespace torrance
