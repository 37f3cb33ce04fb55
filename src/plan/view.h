// One term of the shading equation as a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace torrance {

/// What a term is a property of, and so what a scene must have for it to be drawn.
enum class ViewSubject
{
    surface,
    light,       // one light
    model,       // one light, and a model that has the term
    environment, // light from all around
    table,       // the directional albedos of the preset's lobe
    picture,     // the whole: what is drawn without a view
};

/// The term's value x is shown as factor x + offset. Nothing: 1 over the greatest value of the picture, and 0.
struct ViewScale
{
    double factor = 1.0;
    double offset = 0.0;
};

struct View
{
    std::string_view id; // on the command line
    std::uint32_t code;  // shaders/shared/view.h
    ViewSubject subject;
    std::optional<ViewScale> scale;
    std::string_view text;
};

std::span<const View> allViews();
/// Null where the id is not known.
const View* findView(std::string_view id);

} // namespace torrance
