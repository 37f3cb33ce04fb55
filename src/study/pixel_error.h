// How far one pixel lies from the truth when the truth is known through repeated estimates.
#pragma once

#include "math/replicates.h"
#include "measure/ratio_estimate.h"

namespace torrance {

/// A number with its 95 % interval.
struct Bounded
{
    double value = 0.0;
    double low = 0.0;
    double high = 0.0; // infinity where nothing bounds it
};

/// |x|_1 of a difference x that is known as independent unbiased estimates x_r of it, and |c|_1 beside it.
///
/// The norm of the estimates' mean is too large on average, by Jensen's inequality: E|x + noise| >= |x|. The mean of
/// sign(mean of the others) x_r is too small: the sign does not depend on x_r, so that its expectation is x E[sign] <=
/// |x|. Whatever the noise is like, the truth lies between both expectations; where it is small, they agree.
struct PixelError
{
    double above = 0.0; // on average at least |x|_1
    double below = 0.0; // on average at most |x|_1; may be negative
    double norm = 0.0;  // |c|_1
    // Of above (below scatters alike), norm, and both together.
    double errorVariance = 0.0, normVariance = 0.0, covariance = 0.0;

    /// Their geometric mean. Of normal noise it lies within 20 % of |x| for any |x|: for |x| << sigma, below is 0.798
    /// x^2 / sigma and above 0.798 sigma.
    double middle() const;
    RatioUnit unitAbove() const { return {above, norm, errorVariance, normVariance, covariance}; }
    RatioUnit unitBelow() const { return {below, norm, errorVariance, normVariance, covariance}; }
};

/// `differences` are estimates of x, `truths` of c, made together. A difference that is not finite gives an infinite
/// error.
PixelError pixelError(const Replicates& differences, const Replicates& truths);

/// `drawn` less each estimate of the truth.
PixelError pixelError(const dvec3& drawn, const Replicates& truths);

/// The error of a pixel, |x|_1 / (|c|_1 + floor), with its interval: Student's t on the estimates' spread, that of the
/// denominator added to it.
Bounded relativeError(const PixelError& error, double floor);

} // namespace torrance
