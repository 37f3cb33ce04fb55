#include "plan/light_methods.h"

#include "brdf/environment.h"
#include "brdf/slot_option.h"
#include "plan/settings.h"

#include <algorithm>

namespace torrance {
namespace {

const brdf::Method* methodOf(const LightMethods& own, brdf::Slot slot)
{
    return own.methods[static_cast<std::size_t>(std::ranges::find(kLightSlots, slot) - kLightSlots.begin())];
}

} // namespace

bool drawsEnvironmentSamples(const LightMethods& own)
{
    const brdf::Method* method = methodOf(own, brdf::Slot::environmentSpecular);
    return method && brdf::drawsSamples(*method);
}

bool drawsLightSamples(const LightMethods& own)
{
    const brdf::Method* method = methodOf(own, brdf::Slot::areaLight);
    return method && method->id == "sampled";
}

std::string materialMethodsText(int material, const LightMethods& own)
{
    std::string text = std::to_string(material);
    const auto add = [&](std::string_view name, const std::string& value) {
        text.append(text.find(':') == std::string::npos ? ":" : ",").append(name).append("=").append(value);
    };
    for (std::size_t i = 0; i < kLightSlots.size(); ++i)
        if (own.methods[i])
            add(brdf::slotWord(kLightSlots[i]), std::string(own.methods[i]->id));
    if (drawsEnvironmentSamples(own))
        add(kEnvironmentSamplesName, std::to_string(own.environmentSamples));
    if (drawsLightSamples(own))
        add(kLightSamplesName, std::to_string(own.lightSamples));
    return text;
}

LightMethods lightMethodsOf(const Settings& settings)
{
    LightMethods own;
    for (std::size_t i = 0; i < kLightSlots.size(); ++i)
        own.methods[i] = settings.methods[kLightSlots[i]];
    own.environmentSamples = settings.environmentSamples;
    own.lightSamples = settings.lightSamples;
    return own;
}

LightMethods lightMethodsOf(const Settings& settings, int material)
{
    const auto found = settings.ofMaterials.find(material);
    return found == settings.ofMaterials.end() ? lightMethodsOf(settings) : found->second;
}

Settings withLightMethods(Settings settings, const LightMethods& chosen)
{
    for (std::size_t i = 0; i < kLightSlots.size(); ++i)
        settings.methods[kLightSlots[i]] = chosen.methods[i];
    settings.environmentSamples = chosen.environmentSamples;
    settings.lightSamples = chosen.lightSamples;
    settings.ofMaterials.clear();
    return settings;
}

} // namespace torrance
