// What the implementation promises (GL 1.5 tables 6.31-6.35): one place for the sizes of the state arrays,
// the checks of commands and the answers of glGet.
#pragma once

namespace terrazzo::gl {

inline constexpr int kMaxLights = 8;
inline constexpr int kMaxClipPlanes = 6;
inline constexpr int kMaxTextureUnits = 8;
inline constexpr int kMaxTextureLevels = 15;
inline constexpr int kMaxTextureSize = 1 << (kMaxTextureLevels - 1);
inline constexpr int kMax3dTextureSize = 2048;
inline constexpr int kMaxCubeTextureSize = 16384;
inline constexpr int kMaxRenderbufferSize = 16384;
inline constexpr int kMaxSamples = 4;  // a pixel has so many or one
inline constexpr int kMaxViewportSize = 16384;
inline constexpr int kMinViewportOrigin = -32768;
inline constexpr int kMaxViewportOrigin = 32767;

inline constexpr int kMaxModelviewDepth = 32;
inline constexpr int kMaxProjectionDepth = 32;
inline constexpr int kMaxTextureMatrixDepth = 10;
inline constexpr int kMaxAttribDepth = 16;
inline constexpr int kMaxClientAttribDepth = 16;
inline constexpr int kMaxNameStackDepth = 64;
inline constexpr int kMaxListNesting = 64;
inline constexpr int kMaxPixelMapTable = 256;

inline constexpr int kMaxElementsVertices = 3000;  // of glDrawRangeElements, a recommendation
inline constexpr int kMaxElementsIndices = 3000;

inline constexpr float kMinPointSize = 1.0f;
inline constexpr float kMaxPointSize = 255.0f;
inline constexpr float kMaxTextureLodBias = 16.0f;
inline constexpr float kMaxTextureAnisotropy = 16.0f;
inline constexpr float kPointSizeGranularity = 0.1f;
inline constexpr float kMinLineWidth = 1.0f;
inline constexpr float kMaxLineWidth = 255.0f;
inline constexpr float kLineWidthGranularity = 0.1f;
inline constexpr float kMaxShininess = 128.0f;
inline constexpr float kMaxSpotExponent = 128.0f;
inline constexpr int kSubpixelBits = 8;

}  // namespace terrazzo::gl
