#include "app/material_method_option.h"

#include "app/method_options.h"
#include "app/option_value.h"
#include "brdf/slot_option.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string_view>

namespace torrance {
namespace {

constexpr const char* kOption = "--material-methods";

[[noreturn]] void refuse(const std::string& text, const std::string& problem, const std::string& remedy)
{
    throw usageError(fmt::format("{}={}: {}", kOption, text, problem), remedy);
}

std::optional<int> wholeNumber(std::string_view text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 0)
        return std::nullopt;
    return number;
}

std::string knownNames()
{
    std::vector<std::string> names;
    for (const brdf::Slot slot : kLightSlots)
        names.push_back(brdf::slotWord(slot));
    names.insert(names.end(), {kEnvironmentSamplesName, kLightSamplesName});
    return "known are " + listed(names);
}

const brdf::Method* methodFor(const std::string& text, brdf::Slot slot, const brdf::Method* asked,
                              const std::string& id)
{
    const brdf::Method* method = brdf::findMethod(slot, id);
    if (!method)
        refuse(text, id + " is no method of " + brdf::slotWord(slot), "known are " + listed(methodIds(slot)));
    if (!asked)
        refuse(text, "the preset takes no " + brdf::slotWord(slot), "leave it out, or use --preset standard");
    return method;
}

int samplesFor(const std::string& text, const std::string& name, const std::string& value)
{
    const std::optional<int> samples = wholeNumber(value);
    if (!samples || *samples < 1 || *samples > kMostLightDirections)
        refuse(text, fmt::format("{} is a whole number from 1 to {}", name, kMostLightDirections),
               "give such a number");
    return *samples;
}

void apply(const std::string& text, const std::string& part, LightMethods& own, std::set<std::string>& named)
{
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : part.substr(equals + 1);
    if (!named.insert(name).second)
        refuse(text, name + " is named twice", "leave one out");
    if (name == kEnvironmentSamplesName) {
        own.environmentSamples = samplesFor(text, name, value);
        return;
    }
    if (name == kLightSamplesName) {
        own.lightSamples = samplesFor(text, name, value);
        return;
    }
    const auto slot = std::ranges::find(kLightSlots, name, brdf::slotWord);
    if (slot == kLightSlots.end())
        refuse(text, "'" + name + "' is not chosen by material", knownNames());
    const brdf::Method*& method = own.methods[static_cast<std::size_t>(slot - kLightSlots.begin())];
    method = methodFor(text, *slot, method, value);
}

} // namespace

void declareMaterialMethodOption(CLI::App& app, std::vector<std::string>& texts)
{
    app.add_option(kOption, texts,
                   "How light is computed for one material, by its number: "
                   "0:environment-specular=vndf_lamps,environment-samples=16; may be given several times")
        ->group("Methods")
        ->type_name("NUMBER:NAME=VALUE,...")
        ->expected(1)
        ->take_all();
}

std::map<int, LightMethods> chosenMaterialMethods(const std::vector<std::string>& texts, const Settings& settings)
{
    std::map<int, LightMethods> chosen;
    for (const std::string& text : texts) {
        const std::size_t colon = text.find(':');
        const std::optional<int> material = wholeNumber(std::string_view(text).substr(0, colon));
        if (colon == std::string::npos || !material)
            refuse(text, "has no material's number before a colon", "write 0:environment-specular=split_sum");
        LightMethods own = lightMethodsOf(settings);
        std::set<std::string> named;
        for (const std::string& part : splitAtCommas(text.substr(colon + 1)))
            apply(text, part, own, named);
        if (named.empty())
            refuse(text, "names no method", knownNames());
        if (named.contains(kEnvironmentSamplesName) && !drawsEnvironmentSamples(own))
            refuse(text, "its environment-specular draws no samples", "choose one that does, such as vndf_bounded");
        if (named.contains(kLightSamplesName) && !drawsLightSamples(own))
            refuse(text, "its area-light draws no samples", "choose area-light=sampled");
        if (!chosen.emplace(*material, own).second)
            refuse(text, fmt::format("material {} is named twice", *material), "say all of it in one");
    }
    return chosen;
}

} // namespace torrance
