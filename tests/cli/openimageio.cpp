// OpenImageIO brings 261 libraries: it is opened for what nothing else reads, and for that only.
#include "files/image_encoders.h"
#include "files/image_write.h"
#include "program.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

class OpenImageIo : public ::testing::Test
{
protected:
    // The dynamic loader lists on standard error what it loads.
    bool loadedBy(const std::string& path)
    {
        const Outcome outcome = runTorrance({"compare", path, path}, {"LD_DEBUG=files"});
        EXPECT_NE(outcome.errors.find("calling init"), std::string::npos) << "the loader does not say what it loads";
        return outcome.errors.find("libOpenImageIO") != std::string::npos;
    }

    // Netpbm's PPM, two pixels: a format without a reader in this program.
    std::string ppm()
    {
        std::ofstream(folder.file("a.ppm"), std::ios::binary) << "P6\n2 1\n255\n"
                                                              << std::string("\xff\x80\x00\x00\x80\xff", 6);
        return folder.file("a.ppm");
    }

    TestFolder folder;
    bool built = std::filesystem::exists(TORRANCE_BINARY_DIR "/lib/torrance/torrance_openimageio.so");
};

TEST_F(OpenImageIo, IsNotLoadedForTheUsualFormats)
{
    for (const char* name : {"a.png", "a.jpg", "a.webp", "a.exr", "a.hdr"}) {
        writePicture(folder.file(name), Image(16, 16, 3, 0.5f), {}, {});
        EXPECT_FALSE(loadedBy(folder.file(name))) << name;
    }
}

TEST_F(OpenImageIo, IsNotLoadedToDrawAModel)
{
    const Outcome outcome =
        runTorrance({"render", "demo", "-r", "16x16", "-o", folder.file("a.png")}, {"LD_DEBUG=files"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.errors.find("calling init"), std::string::npos) << "the loader does not say what it loads";
    EXPECT_EQ(outcome.errors.find("libOpenImageIO"), std::string::npos);
}

TEST_F(OpenImageIo, ReadsOtherFormatsWhereItWasBuilt)
{
    const std::string path = ppm();
    if (!built) {
        const Outcome outcome = runTorrance({"compare", path, path});
        EXPECT_EQ(outcome.exitCode, 3);
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find("libopenimageio-dev"), std::string::npos) << outcome.errors;
        return;
    }
    EXPECT_TRUE(loadedBy(path)) << "the check of the other test can fail";
    // The same codes in a PNG: 1, 128/255, 0 and the reverse.
    Image image(2, 1, 3);
    image.texels = {1.0f, 128 / 255.0f, 0.0f, 0.0f, 128 / 255.0f, 1.0f};

    const std::vector<std::byte> png = encodePng(image, 8);
    std::ofstream(folder.file("a.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    const Outcome outcome = runTorrance({"compare", path, folder.file("a.png"), "--max-rmse", "0"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
}

TEST_F(OpenImageIo, SaysInOneLineWhatItCannotRead)
{
    std::ofstream(folder.file("a.tif")) << "II*\0 and then nothing that is a picture";
    const Outcome outcome = runTorrance({"compare", folder.file("a.tif"), folder.file("a.tif")});
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("a.tif"), std::string::npos) << outcome.errors;
}

} // namespace
} // namespace torrance::test
