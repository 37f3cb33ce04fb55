// OBJ and MTL files that something happened to. Whatever it was: a scene or an Error, nothing else. Run it under the
// `asan` preset.
#include "gltf_builder.h"
#include "mutations.h"
#include "pictures.h"

namespace torrance {
namespace {

const std::string kObj =
    "mtllib m.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nv .5 .2 0 1 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\ng front\nusemtl a\ns 1\n"
    "f 1/1/1 2/2/1 3/3/1 4/4/1\nf -5/-4 -1/-3 -4/-2\nusemtl b\ns off\nf 1//1 5//1 2//1 3//1 4//1\n"
    "f 1 2 \\\n 3\nl 1 2\n";
const std::string kMtl =
    "newmtl a\nKa 0 0 0\nKd .5 .25 1\nKs 1 1 1\nNs 96.1\nNi 1.45\nd 0.5\nillum 2\n"
    "map_Kd -s 2 2 2 -o .1 .2 c.png\nmap_d -s 2 2 2 -o .1 .2 -imfchan r c.png\nbump -bm 0.3 g.png\n"
    "newmtl b\nPr 0.5\nPm 1\nPc .1\nKe 1 2 3\nmap_Pr g.png\nmap_Pm -clamp on g.png\nmap_Pm g.png\n"
    "norm c.png\nmap_Ke c.png\n";

class ObjMutations : public testing::Test
{
protected:
    void SetUp() override
    {
        folder.write("c.png", test::pngRow(2, 8, {255, 128, 0, 1, 2, 3}));
        folder.write("g.png", test::pngRow(0, 16, {1000, 1001, 70, 80}));
    }

    bool survives(const std::string& obj, const std::string& mtl)
    {
        folder.write("m.mtl", mtl);
        const auto path = folder.write("model.obj", obj);
        try {
            test::expectSound(loadScene(path).scene);
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input) << error.what();
            EXPECT_FALSE(contains(error.what(), "tinyobjloader")) << "a check of ours is missing: " << error.what();
            return false;
        }
    }

    /// Bytes are changed for others, or for whole words that mean something to the format.
    static std::string mutated(std::string text, test::Random& random)
    {
        static const std::vector<std::string> kWords = {
            "\n", " ",   "/",   "//", "-1",  "0",       "99999999999", "1e999", "nan", "-",       "f ",
            "v ", "vt ", "g",   "o ", "s ",  "usemtl ", "mtllib ",     "\\\n",  "#",   "map_Kd ", "-s ",
            "\r", "\t",  "../", "-o", "-mm", "newmtl ", "1/1/1",       "-bm",   "d "};
        for (std::size_t changes = 1 + random.below(2); changes > 0; --changes) {
            const std::size_t place = random.below(text.size());
            if (random.below(2) == 0)
                text[place] = static_cast<char>(random.next());
            else
                text.replace(place, random.below(4), kWords[random.below(kWords.size())]);
        }
        return text;
    }

    TestFolder folder;
};

TEST_F(ObjMutations, StartFromFilesThatLoad)
{
    EXPECT_TRUE(survives(kObj, kMtl));
    EXPECT_EQ(loadScene(folder.path / "model.obj").scene.primitives.size(), 2u);
}

TEST_F(ObjMutations, SurviveChangedShapes)
{
    test::Random random(1);
    int loaded = 0;
    for (int run = 0; run < 600 && !HasFatalFailure(); ++run)
        loaded += survives(mutated(kObj, random), kMtl) ? 1 : 0;
    EXPECT_GT(loaded, 60) << "most changes should not stop at the first check";
    EXPECT_LT(loaded, 570);
}

TEST_F(ObjMutations, SurviveChangedMaterials)
{
    test::Random random(2);
    int loaded = 0;
    for (int run = 0; run < 600 && !HasFatalFailure(); ++run)
        loaded += survives(kObj, mutated(kMtl, random)) ? 1 : 0;
    EXPECT_GT(loaded, 60);
    EXPECT_LT(loaded, 570);
}

TEST_F(ObjMutations, SurviveTruncation)
{
    for (std::size_t length = 0; length < kObj.size(); length += 3)
        survives(kObj.substr(0, length), kMtl);
    for (std::size_t length = 0; length < kMtl.size(); length += 3)
        survives(kObj, kMtl.substr(0, length));
}

TEST_F(ObjMutations, SurviveGarbage)
{
    test::Random random(3);
    std::string garbage(100000, ' ');
    for (char& c : garbage)
        c = static_cast<char>(random.next());
    EXPECT_FALSE(survives(garbage, kMtl));
    survives(kObj, garbage);
}

} // namespace
} // namespace torrance
