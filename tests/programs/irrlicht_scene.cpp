// A program of the Irrlicht engine: lit, textured and foggy nodes, stencil shadows, a billboard, the scene drawn to a
// texture, an image and text of its GUI; 60 frames whose time is counted, not measured.
#include <irrlicht/irrlicht.h>

#include <cstdio>

namespace {

using namespace irr;
using core::vector3df;
using video::SColor;

constexpr u32 kFrames = 60, kMillisecondsAFrame = 25;

video::ITexture* stripes(video::IVideoDriver& driver, const char* name, SColor light, SColor dark) {
    constexpr u32 kSize = 128;
    video::IImage* const image = driver.createImage(video::ECF_A8R8G8B8, {kSize, kSize});
    for (u32 y = 0; y < kSize; ++y)
        for (u32 x = 0; x < kSize; ++x) image->setPixel(x, y, ((x + y / 2) / 16) % 2 ? light : dark);
    video::ITexture* const texture = driver.addTexture(name, image);
    image->drop();
    return texture;
}

void add_nodes(IrrlichtDevice& device) {
    scene::ISceneManager& scene = *device.getSceneManager();
    video::IVideoDriver& driver = *device.getVideoDriver();
    video::ITexture* const warm = stripes(driver, "warm", {255, 240, 180, 90}, {255, 120, 40, 30});
    video::ITexture* const cool = stripes(driver, "cool", {255, 120, 200, 240}, {255, 20, 40, 110});

    scene::IMesh* const floor = scene.getGeometryCreator()->createPlaneMesh({10, 10}, {12, 12}, nullptr, {8, 8});
    scene::IMeshSceneNode* const ground = scene.addMeshSceneNode(floor, nullptr, -1, {0, -12, 0});
    floor->drop();
    ground->setMaterialTexture(0, cool);
    scene::IMeshSceneNode* const sphere = scene.addSphereSceneNode(9, 24, nullptr, -1, {-14, 2, 0});
    sphere->setMaterialTexture(0, warm);
    sphere->addShadowVolumeSceneNode();
    scene::IMeshSceneNode* const cube = scene.addCubeSceneNode(13, nullptr, -1, {14, 2, 4});
    cube->setMaterialTexture(0, cool);
    cube->addShadowVolumeSceneNode();
    scene::ISceneNodeAnimator* const turn = scene.createRotationAnimator({0.4F, 0.7F, 0});
    cube->addAnimator(turn);
    turn->drop();
    ground->setMaterialFlag(video::EMF_FOG_ENABLE, true);
    ground->setMaterialFlag(video::EMF_NORMALIZE_NORMALS, true);

    scene::IBillboardSceneNode* const glow = scene.addBillboardSceneNode(nullptr, {8, 8}, {0, 10, -6});
    glow->setMaterialTexture(0, warm);
    glow->setMaterialType(video::EMT_TRANSPARENT_ADD_COLOR);
    glow->setMaterialFlag(video::EMF_LIGHTING, false);

    scene.addLightSceneNode(nullptr, {20, 40, -30}, {1, 0.95F, 0.85F}, 90);
    scene.setAmbientLight({0.25F, 0.25F, 0.3F, 1});
    scene.setShadowColor({150, 0, 0, 0});
    driver.setFog({255, 70, 80, 100}, video::EFT_FOG_LINEAR, 40, 130, 0, false, true);
    scene.addCameraSceneNode(nullptr, {0, 18, -46}, {0, -2, 0});
}

// The scene from above, as a picture in the corner.
void draw_map(IrrlichtDevice& device, video::ITexture& map, scene::ICameraSceneNode& above) {
    scene::ISceneManager& scene = *device.getSceneManager();
    scene::ICameraSceneNode* const usual = scene.getActiveCamera();
    device.getVideoDriver()->setRenderTarget(&map, true, true, {255, 30, 30, 40});
    scene.setActiveCamera(&above);
    scene.drawAll();
    scene.setActiveCamera(usual);
    device.getVideoDriver()->setRenderTarget(nullptr, false, false);
}

void draw_frame(IrrlichtDevice& device, video::ITexture* map, scene::ICameraSceneNode& above) {
    video::IVideoDriver& driver = *device.getVideoDriver();
    driver.beginScene(true, true, {255, 70, 80, 100});
    if (map) draw_map(device, *map, above);
    device.getSceneManager()->drawAll();
    if (map) driver.draw2DImage(map, core::position2d<s32>(10, 10));
    driver.draw2DRectangle({10, 150, 138, 170}, {160, 0, 0, 0}, {160, 0, 0, 0}, {160, 90, 90, 0}, {160, 90, 90, 0});
    device.getGUIEnvironment()->drawAll();
    driver.endScene();
}

}  // namespace

int main() {
    IrrlichtDevice* const device = createDevice(video::EDT_OPENGL, {640, 480}, 32, false, true);
    if (!device) {
        std::fputs("irrlicht_scene: no OpenGL device\n", stderr);
        return 1;
    }
    device->getTimer()->stop();
    add_nodes(*device);
    scene::ISceneManager& scene = *device->getSceneManager();
    scene::ICameraSceneNode* const usual = scene.getActiveCamera();
    scene::ICameraSceneNode* const above = scene.addCameraSceneNode(nullptr, {0, 60, -1}, {0, 0, 0}, -1, false);
    scene.setActiveCamera(usual);
    video::IVideoDriver& driver = *device->getVideoDriver();
    video::ITexture* const map = driver.queryFeature(video::EVDF_RENDER_TO_TARGET)
                                     ? driver.addRenderTargetTexture({128, 128}, "map")
                                     : nullptr;
    device->getGUIEnvironment()->addStaticText(L"Irrlicht", {16, 152, 130, 168})->setOverrideColor({255, 255, 255, 255});
    for (u32 frame = 0; frame < kFrames && device->run(); ++frame) {
        device->getTimer()->setTime(frame * kMillisecondsAFrame);
        draw_frame(*device, map, *above);
    }
    device->drop();
    return 0;
}
