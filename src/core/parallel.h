// Work on all cores. What is computed never depends on how many there are: an item sees its index only.
#pragma once

#include <cstddef>
#include <functional>

namespace torrance {

/// Number of worker threads: the cores this process may run on, or TORRANCE_THREADS.
std::size_t workerCount();

/// Calls work(i) once for every i in [0, count), in any order, on all workers; returns when all are done.
/// `grain` consecutive items are taken at a time. The first exception is rethrown here.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& work);

} // namespace torrance
