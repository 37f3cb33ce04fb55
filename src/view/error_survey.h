// The errors of a picture's pixels, found beside everything else, from few to all of them.
#pragma once

#include "image/image.h"
#include "plan/settings.h"
#include "scene/scene.h"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace torrance {

class ErrorSurvey
{
public:
    /// `announce` is called from the survey's thread when there is something new to be shown.
    explicit ErrorSurvey(void (*announceNews)()) : announce(announceNews) {}
    ~ErrorSurvey() { stop(); }
    ErrorSurvey(const ErrorSurvey&) = delete;
    ErrorSurvey& operator=(const ErrorSurvey&) = delete;

    /// Of a picture drawn with these settings. The scene must not be changed before stop(). Throws Error (usage) as
    /// requireCertifiable (study/certificate.h).
    void start(const Scene& scene, const Camera& camera, const Settings& settings, Image drawn);
    void stop();
    bool isRunning() const { return thread.joinable(); }

    /// What is known now.
    struct State
    {
        Image errors; // relative, one channel, on average not too small (PixelError::above): where it lies below
                      // `noise` it says no more than that. A pixel that was not looked at yet has that of one near it,
                      // and what shows no surface is NaN
        std::size_t pixels = 0; // looked at and covered
        double mean = 0.0;      // sum of |d - c|_1 over sum of |c|_1, of these
        double noise = 0.0;     // of the truth of one pixel, the mean standard error over the mean |c|_1
        double done = 0.0;      // share of the picture
        std::string problem;    // why there is nothing; empty where there is
    };
    /// True, once, where something is new since the last call.
    bool takeNews(State& state);

private:
    void run(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn);

    void (*announce)();
    std::thread thread;
    std::atomic<bool> stops = false;
    std::mutex mutex; // of the two below
    State known;
    bool isNew = false;
};

} // namespace torrance
