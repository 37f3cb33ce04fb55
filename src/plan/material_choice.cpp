#include "plan/material_choice.h"

#include <algorithm>
#include <limits>

namespace torrance {
namespace {

struct Change
{
    int material = 0;
    const MaterialTrial* to = nullptr;
    double saving = 0.0; // ns a covered pixel
    double added = 0.0;  // to the error
};

double worth(const Change& change)
{
    return change.added > 0.0 ? change.saving / change.added : std::numeric_limits<double>::infinity();
}

bool isBetter(const Change& a, const Change& b)
{
    return worth(a) != worth(b) ? worth(a) > worth(b) : a.saving > b.saving;
}

} // namespace

std::map<int, LightMethods> cheaperMaterials(const MaterialTrial& found, std::span<const MaterialTrial> others,
                                             std::span<const int> free, double most)
{
    std::map<int, const MaterialTrial*> taken;
    double left = most, cost = 0.0;
    for (const auto& [material, own] : found.errors) {
        left -= own.error;
        cost += own.pixels * found.cost;
        if (std::ranges::find(free, material) != free.end())
            taken[material] = &found;
    }
    double saved = 0.0;
    for (;;) {
        Change best;
        for (const auto& [material, now] : taken)
            for (const MaterialTrial& other : others) {
                const auto measured = other.errors.find(material);
                if (measured == other.errors.end())
                    continue;
                const Change change = {material, &other, found.errors.at(material).pixels * (now->cost - other.cost),
                                       measured->second.error - now->errors.at(material).error};
                if (change.saving > 0.0 && change.added <= left && (!best.to || isBetter(change, best)))
                    best = change;
            }
        if (!best.to)
            break;
        taken[best.material] = best.to;
        left -= best.added;
        saved += best.saving;
    }
    std::map<int, LightMethods> changed;
    if (saved < kLeastMaterialSaving * cost)
        return changed;
    for (const auto& [material, trial] : taken)
        if (trial != &found)
            changed.emplace(material, trial->methods);
    return changed;
}

} // namespace torrance
