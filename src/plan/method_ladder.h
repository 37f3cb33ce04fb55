// The methods that can fill a slot, from cheap to near: what a tolerance chooses from.
#pragma once

#include "plan/method_table.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

/// A surface that is seen, and what comes from it by way of each slot, as shares of all light of the picture: estimates
/// under even light, for they weigh errors and are none.
struct SeenSurface
{
    double perceptualRoughness = 1.0;
    double NoV = 1.0;
    double f0 = 0.04;
    double body = 0.0;    // of an environment
    double lobe = 0.0;    // of an environment
    double spheres = 0.0; // of lights with a radius
};

struct Rung
{
    const brdf::Method* method = nullptr;
    int samples = 0;        // 0: it draws none
    double cost = 0.0;      // ns a pixel, of a whole frame with it; NaN: not measured
    double error = 0.0;     // mean error of the picture that is expected of it
    double costDoubt = 0.0; // ns a pixel: half the width of the cost's 95 % interval
};

/// "vndf_lamps with 64 samples".
std::string nameOf(const Rung& rung);

struct RefusedMethod
{
    const brdf::Method* method = nullptr;
    std::string reason;
};

struct MethodLadder
{
    brdf::Slot slot = brdf::Slot::environmentSpecular;
    /// Ascending in cost and descending in error; the intervals of two methods' costs lie apart, but where one of them
    /// does without a table.
    std::vector<Rung> rungs;
    std::size_t at = 0; // the one that is taken
    std::vector<RefusedMethod> refused;

    const Rung& taken() const { return rungs[at]; }
    bool isHighest() const { return at + 1 == rungs.size(); }
};

/// What of a scene decides where methods are valid.
struct LadderScene
{
    bool environment = false; // it lights something
    bool even = false;        // of one radiance
    bool lamps = true;        // vndf_lamps can be drawn: it has room behind the lights
    bool spheres = false;     // lights with a radius
};

/// Directions that a method which draws samples is tried with. Its table's row is of kTableSamples: cost grows with
/// their number, and error falls with its root, as that of independent samples would; even points do better.
inline constexpr std::array kLadderSamples = {4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096};
inline constexpr int kTableSamples = 64;

/// The error that a row says of these surfaces: by cell of its grid, weighed by the slot's share of the light. The
/// row's truth has noise, which is taken out: of normal noise a mean of absolute values has 0.375 of the half width of
/// its 95 % interval (0.798 of 2.13 standard deviations), added in squares.
double expectedError(const MethodTable& table, const MethodRow& row, std::span<const SeenSurface> surfaces);

/// `asked` fills the slot unless something cheaper or nearer does. None where the slot has nothing to do in the scene,
/// or the table has no figures of what was asked for.
std::optional<MethodLadder> ladderOf(const MethodTable& table, brdf::Slot slot, const brdf::Method& asked,
                                     std::span<const SeenSurface> surfaces, const LadderScene& scene);

} // namespace torrance
