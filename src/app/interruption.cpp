#include "app/interruption.h"

#include <csignal>
#include <cstdlib>

namespace torrance {
namespace {

volatile std::sig_atomic_t signalThatCame = 0;

extern "C" void note(int signal)
{
    signalThatCame = signal;
}

} // namespace

Interruption::Interruption()
{
    signalThatCame = 0;
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

Interruption::~Interruption()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::came() const
{
    return signalThatCame != 0;
}

void Interruption::obey() const
{
    const int signal = signalThatCame;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::abort(); // not reached: the default action of both ends the process
}

} // namespace torrance
