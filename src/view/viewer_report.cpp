#include "view/viewer_report.h"

#include "core/atomic_write.h"
#include "files/json_write.h"
#include "view/render_command.h"

namespace torrance {
namespace {

Json numbers(const dvec4& v)
{
    return Json::Array{v.x, v.y, v.z, v.w};
}

Json materialJson(const Material& material)
{
    return Json::Object{{"name", material.name},
                        {"baseColorFactor", numbers(material.baseColorFactor)},
                        {"metallicFactor", material.metallicFactor},
                        {"roughnessFactor", material.roughnessFactor},
                        {"ior", material.ior},
                        {"unlit", material.unlit}};
}

Json numbers(const dvec3& v)
{
    return Json::Array{v.x, v.y, v.z};
}

void addProbe(const PixelProbe& probe, Json::Object& report)
{
    Json::Array terms;
    for (const ProbedTerm& term : probe.terms)
        terms.push_back(Json::Object{{"slot", std::string(brdf::slotName(term.slot))},
                                     {"method", std::string(term.id)},
                                     {"device", numbers(dvec3(term.device))},
                                     {"exact", numbers(term.exact)}});
    report.emplace_back("probe", Json::Object{{"x", probe.pixel.x},
                                              {"y", probe.pixel.y},
                                              {"drawn", numbers(probe.drawn)},
                                              {"exact", numbers(probe.exact)},
                                              {"error", probe.error.value},
                                              {"terms", std::move(terms)}});
}

void addScene(const ViewerState& state, const ViewerHost& host, Json::Object& report)
{
    const Edits& edits = state.edits();
    Json::Array materials, places;
    for (const Material& material : edits.materials)
        materials.push_back(materialJson(material));
    for (const int place : edits.primitiveMaterials)
        places.emplace_back(place);
    Json::Array lights;
    for (const Light& light : edits.lights)
        lights.push_back(numbers(light.position));
    Json::Array arguments;
    for (const std::string& argument : renderArguments(state, host))
        arguments.emplace_back(argument);
    report.insert(report.end(), {{"scene", state.scene->input},
                                 {"drawn", state.scenesDrawn},
                                 {"command", std::move(arguments)},
                                 {"materials", std::move(materials)},
                                 {"primitive_materials", std::move(places)},
                                 {"lights", std::move(lights)},
                                 {"environment", state.environmentName},
                                 {"environment_rotation", edits.environment.rotation},
                                 {"selected_object", state.selectedInstance},
                                 {"selected_material", state.selectedMaterial},
                                 {"can_undo", state.history->canUndo()},
                                 {"can_redo", state.history->canRedo()},
                                 {"unsaved", state.history->isDirty()}});
    if (state.showsErrors)
        report.emplace_back("errors", Json::Object{{"mean", state.errors.mean}, {"done", state.errors.done}});
    report.emplace_back("finds_methods", state.findsMethods);
    if (state.found)
        report.emplace_back("found", Json::Object{{"holds", state.found->holds},
                                                  {"pictures", state.found->trials.size()},
                                                  {"mean", state.found->certificate.shading.mean.value},
                                                  {"high", state.found->certificate.shading.mean.high}});
    if (state.probe)
        addProbe(*state.probe, report);
}

} // namespace

std::string viewerReport(const ViewerState& state, const ViewerHost& host, const Places& places,
                         const PictureArea& area)
{
    Json::Object report = {
        {"error", state.error}, {"notice", state.notice}, {"opening", state.opening}, {"reads", state.reads}};
    report.emplace_back("picture", Json::Array{area.first.x, area.first.y, area.size.x, area.size.y});
    report.emplace_back("asks_of_unsaved", state.unsaved.has_value());
    if (state.scene)
        addScene(state, host, report);
    Json::Object where;
    for (const auto& [name, place] : places)
        where.emplace_back(name, numbers(dvec4(place)));
    report.emplace_back("places", std::move(where));
    return jsonText(report);
}

void writeReport(const std::string& file, const std::string& text)
{
    writeFile(file, text);
}

} // namespace torrance
