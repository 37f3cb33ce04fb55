#include "view/method_search.h"

#include "core/cancelled.h"

#include <utility>

namespace torrance {

void MethodSearch::start(const Scene& scene, const Camera& camera, const Settings& asked, MethodTable table,
                         const Tolerance& tolerance)
{
    requireCertifiable(scene, asked);
    stop();
    stops = false;
    thread = std::thread([this, &scene, camera, asked, measured = std::move(table), tolerance] {
        const ToleranceTask task = {.scene = scene,
                                    .camera = camera,
                                    .asked = asked,
                                    .table = measured,
                                    .tolerance = tolerance,
                                    .byMaterial = false, // the window has one choice for all
                                    .checkpoint = [this] {
                                        if (stops)
                                            throw Cancelled();
                                    }};
        try {
            ToleranceResult found =
                drawWithin(task, [&](const Settings& settings, std::span<const PixelBox> only) -> const Image& {
                    // What is given is whole: the last trial's picture is the one that is asked for in the end.
                    return only.empty() && picture ? *picture : await(settings);
                });
            const std::lock_guard lock(mutex);
            result = std::move(found);
        } catch (const Cancelled&) {
            return; // whoever stopped it waits for its end
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
        announce();
    });
}

void MethodSearch::stop()
{
    {
        const std::lock_guard lock(mutex); // else the news could come between a look at `stops` and the wait
        stops = true;
    }
    given.notify_all();
    if (thread.joinable())
        thread.join();
    asksFor.reset();
    picture.reset();
    result.reset();
    failure = nullptr;
}

std::optional<Settings> MethodSearch::wanted() const
{
    const std::lock_guard lock(mutex);
    return asksFor;
}

void MethodSearch::give(Image drawn)
{
    {
        const std::lock_guard lock(mutex);
        picture = std::move(drawn);
        asksFor.reset();
    }
    given.notify_all();
}

const Image& MethodSearch::await(const Settings& settings)
{
    std::unique_lock lock(mutex);
    picture.reset();
    asksFor = settings;
    announce();
    given.wait(lock, [&] { return picture || stops; });
    if (stops)
        throw Cancelled();
    return *picture; // nobody gives another before this thread asks again
}

std::optional<ToleranceResult> MethodSearch::take()
{
    {
        const std::lock_guard lock(mutex);
        if (!result && !failure)
            return std::nullopt;
    }
    thread.join();
    if (failure)
        std::rethrow_exception(std::exchange(failure, nullptr));
    return std::exchange(result, std::nullopt);
}

} // namespace torrance
