// How long the parts of a command take, on the wall.
#pragma once

#include "files/json_write.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace torrance {

class Phases
{
public:
    /// Runs `work` and adds its time to the phase of this name.
    template <typename Work>
    auto time(const std::string& name, Work&& work)
    {
        const Stopwatch watch(*this, name);
        return work();
    }
    /// In the order in which they first came; seconds.
    const std::vector<std::pair<std::string, double>>& all() const { return list; }

private:
    class Stopwatch
    {
    public:
        Stopwatch(Phases& p, const std::string& n) : phases(p), name(n), start(std::chrono::steady_clock::now()) {}
        ~Stopwatch()
        {
            phases.add(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }

    private:
        Phases& phases;
        const std::string& name;
        std::chrono::steady_clock::time_point start;
    };
    void add(const std::string& name, double seconds);

    std::vector<std::pair<std::string, double>> list;
};

/// Seconds by the phase's name.
Json phasesAsJson(const Phases& phases);

/// For whoever is watching, and with --verbose.
void reportPhases(const Phases& phases);

} // namespace torrance
