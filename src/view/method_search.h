// Methods found for a tolerance beside everything else. The pictures that it needs are drawn by whoever has the
// renderer.
#pragma once

#include "study/tolerance_search.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace torrance {

class MethodSearch
{
public:
    /// `announce` is called from the search's thread when it wants a picture, and at its end.
    explicit MethodSearch(void (*announceNews)()) : announce(announceNews) {}
    ~MethodSearch() { stop(); }
    MethodSearch(const MethodSearch&) = delete;
    MethodSearch& operator=(const MethodSearch&) = delete;

    /// The scene must not be changed before stop() or the end. Throws Error (usage) as requireCertifiable.
    void start(const Scene& scene, const Camera& camera, const Settings& asked, MethodTable table,
               const Tolerance& tolerance);
    /// Without a result; at once, but for the truth of a pixel that is being computed.
    void stop();
    bool isRunning() const { return thread.joinable(); }

    /// Of the picture that is waited for; nothing where none is.
    std::optional<Settings> wanted() const;
    /// That picture, as the device wrote it.
    void give(Image drawn);

    /// The result, once, and nothing runs any more; nothing while it does. Rethrows what the search threw.
    std::optional<ToleranceResult> take();

private:
    const Image& await(const Settings& settings);

    void (*announce)();
    std::thread thread;
    std::atomic<bool> stops = false;
    mutable std::mutex mutex; // of what follows
    std::condition_variable given;
    std::optional<Settings> asksFor;
    std::optional<Image> picture;
    std::optional<ToleranceResult> result;
    std::exception_ptr failure;
};

} // namespace torrance
