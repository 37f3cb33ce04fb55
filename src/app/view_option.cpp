#include "app/view_option.h"

#include "app/option_value.h"
#include "core/error.h"
#include "image/linear_scale.h"
#include "plan/view_scale.h"

#include <CLI/CLI.hpp>

namespace torrance {

void declareViewOptions(CLI::App& app, ViewOptions& options)
{
    std::vector<std::string> names;
    for (const View& view : allViews())
        names.emplace_back(view.id);
    addChoice(app, "--view", options.view, names, "Draw one term instead of the picture")->group("Output");
    app.add_option("--view-light", options.light,
                   "The light whose terms are drawn, from 0: directional, then point, then spot lights (default 0)")
        ->group("Output")
        ->check(CLI::Range(0, 1 << 20));
}

void chooseView(const ViewOptions& options, const OutputOptions& output, Settings& settings)
{
    const View* view = options.view.empty() ? nullptr : findView(options.view);
    const bool ofLight = view && (view->subject == ViewSubject::light || view->subject == ViewSubject::model);
    if (options.light && !ofLight)
        throw usageError("--view-light is for the terms of one light", "give one of them with --view, or leave it out");
    if (!view || view->subject == ViewSubject::picture)
        return;
    if (!output.tone.empty() || output.exposure)
        throw usageError("--view " + options.view + " draws numbers, which --tone and --exposure are not for",
                         "leave them out");
    settings.view = view;
    settings.viewLight = options.light.value_or(0);
    if (settings.background == BackgroundKind::environment)
        settings.background = BackgroundKind::color; // black
}

ShownView showView(const View& view, const Image& drawn, bool sceneLinearFile)
{
    if (sceneLinearFile)
        return {drawn, {}};
    const ViewScale scale = scaleOf(view, drawn);
    return {scaled(drawn, scale.factor, scale.offset), scale};
}

Json viewAsJson(const Settings& settings, const ViewScale& scale)
{
    Json::Object object = {
        {"term", std::string(settings.view->id)}, {"factor", scale.factor}, {"offset", scale.offset}};
    const ViewSubject subject = settings.view->subject;
    if (subject == ViewSubject::light || subject == ViewSubject::model)
        object.emplace_back("light", settings.viewLight);
    return object;
}

} // namespace torrance
