// Gauss-Legendre rules: n nodes integrate every polynomial of degree 2n - 1 exactly.
#pragma once

#include <vector>

namespace torrance {

struct QuadratureRule
{
    std::vector<double> nodes; // ascending, inside the interval
    std::vector<double> weights;

    std::size_t size() const { return nodes.size(); }
};

/// The n-point rule (n >= 1) on [from, to]; weights sum to to - from.
QuadratureRule gaussLegendre(int n, double from, double to);

/// Sum of weight * f(node).
template <typename Function>
double integrate(const QuadratureRule& rule, const Function& f)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.size(); ++i)
        sum += rule.weights[i] * f(rule.nodes[i]);
    return sum;
}

} // namespace torrance
