#include "prepare/environment_lamps.h"

#include "math/cube.h"
#include "prepare/radiance_pyramid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace torrance {
namespace {

/// Places along each side at which a region may be cut.
constexpr int kCuts = 16;

double meanOf(const float* rgb)
{
    return (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3.0;
}

/// kLampFactor times a mean over the sphere that lamps do not lift: limit and mean are taken from each other until they
/// agree.
double lampThreshold(const std::vector<float>& radiance, int size)
{
    constexpr int kRounds = 40;
    double limit = HUGE_VAL;
    for (int round = 0; round < kRounds; ++round) {
        double sum = 0.0;
        for (int face = 0; face < kCubeFaces; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    sum += cubeTexelSolidAngle(x, y, size) *
                           std::min(meanOf(radiance.data() + 4 * cubeTexelIndex(face, x, y, size)), limit);
        const double next = kLampFactor * sum / (4.0 * kPi);
        const bool settled = next > 0.99 * limit;
        limit = next;
        if (settled)
            break;
    }
    return limit;
}

/// Sums of a rectangle are differences of sums over the face: light below this share of the face's is their rounding.
/// No point stands for it, and it goes back to the rest.
constexpr double kSumRounding = 1e-10;

/// What is summed over texels.
struct Sums
{
    dvec3 energy = dvec3(0.0);
    dvec3 towards = dvec3(0.0); // direction, weighed by light
    double light = 0.0;         // mean of the channels times solid angle
    double square = 0.0;        // its square times solid angle
    double solidAngle = 0.0;

    Sums& operator+=(const Sums& b)
    {
        energy += b.energy;
        towards += b.towards;
        light += b.light;
        square += b.square;
        solidAngle += b.solidAngle;
        return *this;
    }
    Sums& operator-=(const Sums& b)
    {
        energy -= b.energy;
        towards -= b.towards;
        light -= b.light;
        square -= b.square;
        solidAngle -= b.solidAngle;
        return *this;
    }
};

/// Sums over any rectangle of a face from four corners (Crow 1984).
class FaceSums
{
public:
    FaceSums(const std::vector<float>& lamps, int face, int faceSize)
        : size(faceSize), table(static_cast<std::size_t>(faceSize + 1) * static_cast<std::size_t>(faceSize + 1))
    {
        for (int y = 0; y < size; ++y) {
            Sums row;
            for (int x = 0; x < size; ++x) {
                const float* rgb = lamps.data() + 4 * cubeTexelIndex(face, x, y, size);
                const double omega = cubeTexelSolidAngle(x, y, size), mean = meanOf(rgb);
                row += {omega * dvec3(rgb[0], rgb[1], rgb[2]), omega * mean * cubeTexelDirection(face, x, y, size),
                        omega * mean, omega * mean * mean, omega};
                at(x + 1, y + 1) = at(x + 1, y);
                at(x + 1, y + 1) += row;
            }
        }
    }

    Sums over(int x0, int x1, int y0, int y1) const
    {
        Sums sums = at(x1, y1);
        sums += at(x0, y0);
        sums -= at(x0, y1);
        sums -= at(x1, y0);
        if (sums.light < kSumRounding * at(size, size).light)
            sums.light = 0.0;
        return sums;
    }

private:
    Sums& at(int x, int y) { return table[static_cast<std::size_t>(y * (size + 1) + x)]; }
    const Sums& at(int x, int y) const { return table[static_cast<std::size_t>(y * (size + 1) + x)]; }

    int size;
    std::vector<Sums> table;
};

struct Region
{
    int face = 0, x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    Sums sums;
    double difficulty = 0.0;
    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
};

// Standing for the region by one point of even density: its second moment under that density (the region's light where
// it is even, more where it is not), times the extent of its directions, 1 - |mean|^2 = their variance.
double difficultyOf(const Sums& sums)
{
    if (!(sums.light > 0.0))
        return 0.0;
    const double moment = sums.solidAngle * sums.square / sums.light;
    const dvec3 mean = sums.towards / sums.light;
    return moment * std::sqrt(std::max(1.0 - glm::dot(mean, mean), 0.0));
}

Region regionOf(const FaceSums& sums, int face, int x0, int x1, int y0, int y1)
{
    Region region = {face, x0, x1, y0, y1, sums.over(x0, x1, y0, y1), 0.0};
    if ((x1 - x0) * (y1 - y0) > 1)
        region.difficulty = difficultyOf(region.sums);
    return region;
}

std::pair<Region, Region> cutAtBest(const FaceSums& sums, const Region& region)
{
    std::pair<Region, Region> best;
    double least = HUGE_VAL;
    const auto consider = [&](const Region& a, const Region& b) {
        // Of single texels the difficulty is 0, so that the sums' own is compared.
        const double difficulty = difficultyOf(a.sums) + difficultyOf(b.sums);
        if (difficulty < least) {
            least = difficulty;
            best = {a, b};
        }
    };
    const int f = region.face, x0 = region.x0, x1 = region.x1, y0 = region.y0, y1 = region.y1;
    for (int x = x0 + 1; x < x1; x += std::max(1, (x1 - x0) / kCuts))
        consider(regionOf(sums, f, x0, x, y0, y1), regionOf(sums, f, x, x1, y0, y1));
    for (int y = y0 + 1; y < y1; y += std::max(1, (y1 - y0) / kCuts))
        consider(regionOf(sums, f, x0, x1, y0, y), regionOf(sums, f, x0, x1, y, y1));
    return best;
}

std::vector<Region> cutIntoRegions(const std::vector<float>& lamps, int size, int count)
{
    std::vector<FaceSums> sums;
    for (int face = 0; face < kCubeFaces; ++face)
        sums.emplace_back(lamps, face, size);
    std::vector<Region> regions;
    for (int face = 0; face < kCubeFaces; ++face)
        regions.push_back(regionOf(sums[static_cast<std::size_t>(face)], face, 0, size, 0, size));
    const auto easier = [](const Region& a, const Region& b) { return a.difficulty < b.difficulty; };
    std::ranges::make_heap(regions, easier);
    while (static_cast<int>(regions.size()) < count && regions.front().difficulty > 0.0) {
        std::ranges::pop_heap(regions, easier);
        const Region hardest = regions.back();
        regions.pop_back();
        const auto [a, b] = cutAtBest(sums[static_cast<std::size_t>(hardest.face)], hardest);
        for (const Region& part : {a, b}) {
            regions.push_back(part);
            std::ranges::push_heap(regions, easier);
        }
    }
    return regions;
}

// The mean radiance of what shines in it, by its light: a region may reach beyond its lamp. At least the mean over the
// region (Cauchy and Schwarz), which stands where the square is nothing but the rounding of a brighter lamp's.
double brightnessOf(const Region& region)
{
    return std::max(region.sums.square / region.sums.light, region.sums.light / region.sums.solidAngle);
}

// Light, and light times the logarithm of brightness, of regions that shine.
struct KindSums
{
    double light = 0.0, logs = 0.0;
    void add(const Region& region)
    {
        light += region.sums.light;
        logs += region.sums.light * std::log(brightnessOf(region));
    }
    double meanLog() const { return light > 0.0 ? logs / light : 0.0; }
};

// The brightness from which lamps are small ones: where it parts the logarithms, by their light, into two kinds that
// vary least within themselves, that is most between each other (Otsu 1979).
double leastOfSmallLamps(std::vector<Region> regions)
{
    std::erase_if(regions, [](const Region& region) { return !(region.sums.light > 0.0); });
    std::ranges::sort(regions, {}, brightnessOf);
    KindSums all, wide;
    for (const Region& region : regions)
        all.add(region);
    double limit = 0.0, most = 0.0;
    for (std::size_t i = 0; i + 1 < regions.size(); ++i) {
        wide.add(regions[i]);
        const KindSums small = {all.light - wide.light, all.logs - wide.logs};
        const double apart = small.meanLog() - wide.meanLog();
        const double between = wide.light * small.light * apart * apart;
        if (between > most && brightnessOf(regions[i]) < brightnessOf(regions[i + 1])) {
            most = between;
            limit = brightnessOf(regions[i + 1]);
        }
    }
    return limit;
}

// Of each kind the share of all lamps' light that a steradian of it has: the mean by light, of logarithms as above.
LampDensities densitiesOf(const std::vector<Region>& regions, double limit)
{
    KindSums wide, small;
    for (const Region& region : regions)
        if (region.sums.light > 0.0)
            (brightnessOf(region) >= limit ? small : wide).add(region);
    const double light = wide.light + small.light;
    if (!(light > 0.0))
        return {};
    const auto density = [&](const KindSums& kind) { return std::exp(kind.meanLog()) / light; };
    return {density(wide.light > 0.0 ? wide : small), density(small)};
}

} // namespace

EnvironmentLamps splitLamps(const std::vector<float>& radiance, int size, int count)
{
    const double threshold = lampThreshold(radiance, size);
    std::vector<float> rest = radiance, lamps(radiance.size(), 0.0f);
    for (std::size_t i = 0; i < radiance.size(); i += 4) {
        const double mean = meanOf(&radiance[i]);
        const double share = mean > threshold ? threshold / mean : 1.0;
        for (std::size_t c = i; c < i + 3; ++c) {
            rest[c] = static_cast<float>(share * double(radiance[c]));
            lamps[c] = static_cast<float>((1.0 - share) * double(radiance[c]));
        }
    }
    const std::vector<Region> regions = cutIntoRegions(lamps, size, count);
    EnvironmentLamps result;
    const double limit = leastOfSmallLamps(regions);
    result.densities = densitiesOf(regions, limit);
    for (const Region& region : regions) {
        const bool shines = region.sums.light > 0.0, small = shines && brightnessOf(region) >= limit;
        if (shines && static_cast<int>(result.points.size()) < count)
            result.points.push_back({glm::normalize(region.sums.towards), region.sums.energy,
                                     small ? result.densities.small : result.densities.wide});
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x) {
                const std::size_t i = 4 * cubeTexelIndex(region.face, x, y, size);
                if (small)
                    lamps[i + 3] = static_cast<float>(meanOf(&lamps[i]));
                for (std::size_t c = i; !shines && c < i + 3; ++c)
                    rest[c] += std::exchange(lamps[c], 0.0f);
            }
    }
    result.points.resize(static_cast<std::size_t>(count));
    result.rest = radiancePyramid(rest, size);
    result.lamps = radiancePyramid(lamps, size);
    return result;
}

} // namespace torrance
