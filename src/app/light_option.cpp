#include "app/light_option.h"

#include "app/option_value.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "scene/constant_light.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

namespace torrance {
namespace {

// What each kind of light can be given, and what it must be given.
struct KindOfLight
{
    const char* name;
    Light::Kind kind;
    std::vector<std::string> names;
    const char* needed;
};

const std::vector<KindOfLight>& kinds()
{
    static const std::vector<KindOfLight> all = {
        {"constant", Light::Kind::directional, {"direction", "distance", "intensity", "color"}, "direction"},
        {"directional", Light::Kind::directional, {"direction", "intensity", "color"}, "direction"},
        {"point", Light::Kind::point, {"position", "intensity", "color", "range"}, "position"},
    };
    return all;
}

[[noreturn]] void refuse(const std::string& text, const std::string& problem, const std::string& remedy)
{
    throw usageError("--light " + text + ": " + problem, remedy);
}

const KindOfLight& kindOf(const std::string& text)
{
    const std::string name = text.substr(0, text.find(':'));
    std::vector<std::string> known;
    for (const KindOfLight& kind : kinds()) {
        if (name == kind.name)
            return kind;
        known.emplace_back(kind.name);
    }
    const std::string nearest = nearestName(name, known);
    refuse(text, "there is no light of the kind " + name,
           nearest.empty() ? "known are constant, directional and point" : "did you mean " + nearest + "?");
}

// "a=1,b=2,3,4" by name: a part without '=' goes on with the value before it.
std::map<std::string, std::string> valuesOf(const std::string& text, const KindOfLight& kind)
{
    std::map<std::string, std::string> values;
    std::string last;
    const std::size_t colon = text.find(':');
    for (std::size_t at = colon == std::string::npos ? text.size() : colon + 1; at < text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string part = text.substr(at, end - at);
        at = end + 1;
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos && !last.empty()) {
            values[last] += "," + part;
            continue;
        }
        last = part.substr(0, equals);
        if (equals == std::string::npos || std::ranges::find(kind.names, last) == kind.names.end())
            refuse(text, std::string("a ") + kind.name + " light has no " + last, "it takes " + listed(kind.names));
        if (!values.emplace(last, part.substr(equals + 1)).second)
            refuse(text, last + " is given twice", "give it once");
    }
    if (!values.contains(kind.needed))
        refuse(text, std::string("its ") + kind.needed + " is missing", std::string("add ") + kind.needed + "=X,Y,Z");
    return values;
}

dvec3 vectorOf(const std::string& text, const std::string& value)
{
    const std::vector<double> v = parseNumbers("--light " + text, value, 3, 3);
    return {v[0], v[1], v[2]};
}

double numberOf(const std::string& text, const std::string& name, const std::map<std::string, std::string>& values,
                double byDefault)
{
    const auto found = values.find(name);
    const double number =
        found == values.end() ? byDefault : parseNumbers("--light " + text, found->second, 1, 1).front();
    if (!(number >= 0.0))
        refuse(text, name + " is negative", "give 0 or more");
    return number;
}

dvec3 directionOf(const std::string& text, const std::string& value)
{
    const dvec3 direction = vectorOf(text, value);
    if (direction == dvec3(0.0))
        refuse(text, "its direction has no length", "give the way from the scene to the light, such as 0,1,1");
    return direction;
}

} // namespace

void declareLightOptions(CLI::App& app, LightOptions& options)
{
    app.add_option("--light", options.lights,
                   "A light beside the scene's: constant:direction=X,Y,Z,distance=D,intensity=I (the same everywhere, "
                   "intensity/distance^2), directional:direction=X,Y,Z,intensity=LUX or "
                   "point:position=X,Y,Z,intensity=CANDELA; directions lead to the light; color=R,G,B; may be repeated")
        ->group("Light")
        ->type_name("KIND:NAME=VALUE,...")
        ->expected(1)
        ->take_all();
}

Light parseLight(const std::string& text)
{
    const KindOfLight& kind = kindOf(text);
    const auto values = valuesOf(text, kind);
    const double intensity = numberOf(text, "intensity", values, 1.0);
    Light light;
    if (kind.kind == Light::Kind::point) {
        light.kind = Light::Kind::point;
        light.position = vectorOf(text, values.at("position"));
        light.intensity = intensity;
        light.range = numberOf(text, "range", values, 0.0);
    } else {
        const double distance = numberOf(text, "distance", values, 1.0);
        if (!(distance > 0.0))
            refuse(text, "its distance is 0", "give metres above 0");
        light = constantLight(directionOf(text, values.at("direction")), distance, intensity);
    }
    light.name = text;
    if (const auto color = values.find("color"); color != values.end())
        light.color = vectorOf(text, color->second);
    if (!(std::min({light.color.r, light.color.g, light.color.b}) >= 0.0))
        refuse(text, "its color is negative", "give linear factors of 0 or more");
    return light;
}

void addChosenLights(const LightOptions& options, const brdf::Preset& methods, Scene& scene)
{
    for (const std::string& text : options.lights)
        scene.lights.push_back(parseLight(text));
    if (const std::optional<Light> lamp = presetLamp(methods); lamp && scene.lights.empty())
        scene.lights.push_back(*lamp);
}

std::optional<Light> presetLamp(const brdf::Preset& methods)
{
    if (methods.light.empty())
        return std::nullopt;
    Light light = parseLight(std::string(methods.light));
    light.name += ", which the preset " + std::string(methods.id) + " brings";
    return light;
}

} // namespace torrance
