#include "math/quadrature.h"

#include "math/vector.h"

#include <cassert>
#include <cmath>

namespace torrance {
namespace {

struct Legendre
{
    double value;
    double derivative;
};

/// P_n(x) by Bonnet's recurrence and P_n'(x) from it (Abramowitz & Stegun 22.7.10, 22.8.5).
Legendre legendre(int n, double x)
{
    double previous = 1.0;
    double current = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
        previous = current;
        current = next;
    }
    return {current, n * (x * current - previous) / (x * x - 1.0)};
}

constexpr int kNewtonSteps = 8; // quadratic from a guess good to O(n^-4): three are enough, the rest cost nothing

} // namespace

QuadratureRule gaussLegendre(int n, double from, double to)
{
    assert(n >= 1);
    QuadratureRule rule;
    rule.nodes.resize(static_cast<std::size_t>(n));
    rule.weights.resize(static_cast<std::size_t>(n));
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    for (int i = 0; i < (n + 1) / 2; ++i) {
        double x = std::cos(kPi * (i + 0.75) / (n + 0.5)); // Tricomi's guess, largest root first
        for (int step = 0; step < kNewtonSteps; ++step) {
            const Legendre p = legendre(n, x);
            x -= p.value / p.derivative;
        }
        if (2 * i + 1 == n)
            x = 0.0; // the middle root of an odd rule
        const double derivative = legendre(n, x).derivative;
        const double weight = 2.0 / ((1.0 - x * x) * derivative * derivative);
        const auto low = static_cast<std::size_t>(i);
        const auto high = static_cast<std::size_t>(n - 1 - i);
        rule.nodes[low] = middle - half * x;
        rule.nodes[high] = middle + half * x;
        rule.weights[low] = rule.weights[high] = half * weight;
    }
    return rule;
}

} // namespace torrance
