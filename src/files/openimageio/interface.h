// What the module offers, in C: it is found by name.
#pragma once

extern "C" {

struct TorranceOiioPicture
{
    int width;
    int height;
    int channels;
    int displayReferred;      // the file holds integers: codes, not light
    const float* texels;      // width * height * channels, top row first; integers scaled to [0, 1]
    const char* channelNames; // one a line
    void* owner;              // of the two above
};

struct TorranceOiioLimits
{
    int side;
    long long values;
};

/// Reads the first picture of a file. 0: done, to be released. Otherwise `problem` says what is wrong, ending in a zero
/// byte.
using TorranceOiioRead = int (*)(const char* path, TorranceOiioLimits limits, TorranceOiioPicture* picture,
                                 char* problem, int problemBytes);
using TorranceOiioRelease = void (*)(TorranceOiioPicture* picture);
}

inline constexpr const char* kOiioReadName = "torranceOiioRead";
inline constexpr const char* kOiioReleaseName = "torranceOiioRelease";
