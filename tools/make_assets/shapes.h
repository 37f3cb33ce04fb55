// The shapes of the demo scene. Metres; +Y up; every surface's normal points outwards.
#pragma once

#include "make_assets/surface.h"

#include <array>
#include <vector>

namespace torrance::assets {

/// A curve in the half plane (radius, height), by arc length, with its outward normal.
struct ProfilePoint
{
    dvec2 point;
    dvec2 normal;
    double length; // from the start
};
using Profile = std::vector<ProfilePoint>;

/// A smooth curve through the points (Catmull and Rom 1974, centripetal).
Profile smoothProfile(const std::vector<dvec2>& points, int stepsPerSpan);

/// Straight lines whose corners are rounded with arcs of `radius`.
Profile roundedProfile(const std::vector<dvec2>& points, double radius, int stepsPerCorner);

/// A profile turned about +Y; it is given from the bottom, up the outside. uv = (turn, 1 - part of the length).
Surface lathe(const Profile& profile, int columns);

/// The flat top of a lathe, facing +Y at y = 0, made from the square without a pole. uv = (x, z).
Surface disc(double radius, int columns);

/// Barr 1981, "Superquadrics and Angle-Preserving Transformations". Exponents of 1 give an ellipsoid, less a rounder
/// box.
Surface superellipsoid(const dvec3& radii, double exponentAround, double exponentUp, int columns, int rows);

/// A tube round the (p, q) curve on a torus.
Surface torusKnot(int p, int q, double ringRadius, double torusRadius, double tubeRadius, int columns, int rows);

/// Six faces that meet in the middle of their rounded edges: front, back, right, left, top, bottom. uv in metres from
/// each face's upper left corner.
std::vector<Surface> roundedBox(const dvec3& halfSize, double radius, int stepsPerCorner);

/// A tapering tube along a cubic Bezier curve.
Surface stem(const std::array<dvec3, 4>& control, double startRadius, double endRadius, int columns, int rows);

/// A leaf of `length` and `width` that starts at `root`, goes along `direction` and curls down. Its face points to
/// `face`. uv covers the leaf's picture, tip up.
Surface leaf(const dvec3& root, const dvec3& direction, const dvec3& face, double length, double width, double curl);

/// A photographer's sweep: floor, quarter circle, wall, open to +Z. Its floor is y = 0.
Surface sweep(double halfWidth, double front, double back, double radius, double height);

} // namespace torrance::assets
