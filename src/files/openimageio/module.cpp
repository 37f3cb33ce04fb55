#include "files/openimageio/interface.h"

#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

struct Held
{
    std::vector<float> texels;
    std::string channelNames;
};

int fail(const std::string& text, char* problem, int problemBytes)
{
    std::snprintf(problem, static_cast<std::size_t>(problemBytes), "%s", text.substr(0, text.find('\n')).c_str());
    return 1;
}

std::string sizeProblem(const OIIO::ImageSpec& spec, TorranceOiioLimits limits)
{
    const long long width = spec.width, height = spec.height, channels = spec.nchannels;
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (spec.deep || spec.depth > 1)
        return "the picture is deep or a volume";
    if (width <= 0 || height <= 0 || channels <= 0)
        return "the picture is " + size;
    if (width > limits.side || height > limits.side || width * height > limits.values / channels)
        return "the picture is " + size + " with " + std::to_string(channels) + " channels, larger than what is read";
    return "";
}

int read(const char* path, TorranceOiioLimits limits, TorranceOiioPicture& picture, char* problem, int problemBytes)
{
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // straight alpha stays as it is stored
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input)
        return fail(OIIO::geterror(), problem, problemBytes);
    const OIIO::ImageSpec& spec = input->spec();
    if (const std::string wrong = sizeProblem(spec, limits); !wrong.empty())
        return fail(wrong, problem, problemBytes);
    auto held = std::make_unique<Held>();
    held->texels.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                        static_cast<std::size_t>(spec.nchannels));
    for (const std::string& name : spec.channelnames)
        held->channelNames += name + "\n";
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, held->texels.data()))
        return fail(input->geterror(), problem, problemBytes);
    picture = {.width = spec.width,
               .height = spec.height,
               .channels = spec.nchannels,
               .displayReferred = spec.format.is_floating_point() ? 0 : 1,
               .texels = held->texels.data(),
               .channelNames = held->channelNames.c_str(),
               .owner = held.get()};
    held.release();
    return 0;
}

} // namespace

extern "C" __attribute__((visibility("default"))) int torranceOiioRead(const char* path, TorranceOiioLimits limits,
                                                                       TorranceOiioPicture* picture, char* problem,
                                                                       int problemBytes)
{
    try {
        return read(path, limits, *picture, problem, problemBytes);
    } catch (const std::exception& error) { // none may cross the boundary
        return fail(error.what(), problem, problemBytes);
    }
}

extern "C" __attribute__((visibility("default"))) void torranceOiioRelease(TorranceOiioPicture* picture)
{
    delete static_cast<Held*>(picture->owner);
}
