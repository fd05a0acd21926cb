// Matrix arithmetic against bit patterns recorded from the reference library (Mesa 22.3.6).

#include "gl/matrix_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "simd/trigonometry.h"

namespace terrazzo::gl {
namespace {

using simd::cosine;
using simd::sine;

constexpr Matrix4 kRotateGeneral = {{
    0x1.b34ca4p-1f,
    0x1.d6c366p-2f,
    -0x1.06b55cp-2f,
    0x0p+0f,
    -0x1.a7901ap-2f,
    0x1.c4ffep-1f,
    0x1.b7b5bcp-3f,
    0x0p+0f,
    0x1.4d825p-2f,
    -0x1.3903e2p-4f,
    0x1.e27ffp-1f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x1p+0f,
}};
constexpr Matrix4 kRotateY = {{
    0x1.0907dep-2f,
    0x0p+0f,
    -0x1.ee8dd4p-1f,
    0x0p+0f,
    0x0p+0f,
    0x1p+0f,
    0x0p+0f,
    0x0p+0f,
    0x1.ee8dd4p-1f,
    0x0p+0f,
    0x1.0907dep-2f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x1p+0f,
}};
constexpr Matrix4 kOrtho = {{
    0x1.2d2d2ep-1f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x1.400002p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    -0x1.aaaaacp-3f,
    0x0p+0f,
    -0x1.e1e1e2p-3f,
    -0x1p-3f,
    -0x1.055556p+0f,
    0x1p+0f,
}};
constexpr Matrix4 kFrustum = {{
    0x1.e1e1e4p-5f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x0p+0f,
    0x1.000002p-3f,
    0x0p+0f,
    0x0p+0f,
    0x1.e1e1e2p-3f,
    0x1p-3f,
    -0x1.055556p+0f,
    -0x1p+0f,
    0x0p+0f,
    0x0p+0f,
    -0x1.9ddddep-3f,
    0x0p+0f,
}};
constexpr Matrix4 kUniform = {{
    0x1.052dfcp-2f,
    0x1.1a753ep-3f,
    -0x1.3b4008p-4f,
    0x0p+0f,
    -0x1.fc4686p-4f,
    0x1.0fccbap-2f,
    0x1.07d372p-4f,
    0x0p+0f,
    0x1.9035fap-4f,
    -0x1.779e44p-6f,
    0x1.217ff8p-2f,
    0x0p+0f,
    0x1.19999ap+0f,
    -0x1.266666p+1f,
    0x1.666666p-1f,
    0x1p+0f,
}};
constexpr Matrix4 kUniformInverse = {{
    0x1.6abfdep+1f,
    -0x1.60f816p+0f,
    0x1.15ec98p+0f,
    0x0p+0f,
    0x1.884d8p+0f,
    0x1.797fe4p+1f,
    -0x1.04d892p-2f,
    0x0p+0f,
    -0x1.b5d8eep-1f,
    0x1.6e6cc8p-1f,
    0x1.92154ap+1f,
    0x0p+0f,
    0x1.017e74p+0f,
    0x1.f320fcp+2f,
    -0x1.fd4f4cp+1f,
    0x1p+0f,
}};
constexpr Matrix4 kAffine = {{
    0x1.052dfcp-2f,
    0x1.1a753ep-3f,
    -0x1.3b4008p-4f,
    0x0p+0f,
    -0x1.fc4686p-3f,
    0x1.0fccbap-1f,
    0x1.07d372p-3f,
    0x0p+0f,
    0x1.542de2p-3f,
    -0x1.3f4688p-5f,
    0x1.ec265ap-2f,
    0x0p+0f,
    0x1.19999ap+0f,
    -0x1.266666p+1f,
    0x1.666666p-1f,
    0x1p+0f,
}};
constexpr Matrix4 kAffineInverse = {{
    0x1.6abfdap+1f,
    -0x1.60f814p-1f,
    0x1.46f834p-1f,
    0x0p+0f,
    0x1.884d7ep+0f,
    0x1.797fe2p+0f,
    -0x1.32e0bp-3f,
    0x0p+0f,
    -0x1.b5d8ecp-1f,
    0x1.6e6cc4p-2f,
    0x1.d909f6p+0f,
    0x0p+0f,
    0x1.017e78p+0f,
    0x1.f320f6p+1f,
    -0x1.2b980ap+1f,
    0x1p+0f,
}};
constexpr Matrix4 kProjective = {{
    0x1.eba1dcp-7f,
    0x1.09d7c4p-7f,
    -0x1.28b4bep-8f,
    0x0p+0f,
    -0x1.fc468ap-6f,
    0x1.0fccbcp-4f,
    0x1.07d374p-6f,
    0x0p+0f,
    -0x1.3d962ap+0f,
    0x1.3823ep+1f,
    -0x1.315082p+0f,
    -0x1p+0f,
    -0x1.12fa6cp-5f,
    0x1.0214cp-7f,
    -0x1.8dd234p-4f,
    0x0p+0f,
}};
constexpr Matrix4 kProjectiveInverse = {{
    0x1.816bdcp+5f,
    -0x1.60f814p+2f,
    -0x1.1973dep-26f,
    -0x1.947f9ap+1f,
    0x1.a0d258p+4f,
    0x1.797fe4p+3f,
    0x1.1973dep-28f,
    0x1.7ba478p-1f,
    -0x1.d13678p+3f,
    0x1.6e6cdap+1f,
    -0x1.1973dep-24f,
    -0x1.2499f4p+3f,
    0x1.519666p+4f,
    0x1.01907cp+5f,
    -0x1.fffffep-1f,
    0x1.0a23fcp+4f,
}};

struct SineCase {
    float radians, sine, cosine;
};

// The first three are where glibc's FMA variant differs from its plain one.
constexpr SineCase kSines[] = {
    {0x1.1475b6p+4f, -0x1p+0f, -0x1.69eeep-16f},
    {0x1.05d696p+5f, 0x1.ef3108p-1f, 0x1.0439c4p-2f},
    {0x1.46b80ep+6f, -0x1.b54768p-10f, 0x1.ffffd2p-1f},
    {0x1p-1f, 0x1.eaee88p-2f, 0x1.c1528p-1f},
    {-0x1.8p+1f, -0x1.210386p-3f, -0x1.fae04cp-1f},
    {0x1.2a05f2p+33f, -0x1.f334c8p-2f, 0x1.bf098ap-1f},
    {0x1p-13f, 0x1p-13f, 0x1p+0f},
    {0x1.df999ap+6f, 0x1.fc57fep-2f, 0x1.bc749ap-1f},
    {0x1.e2p+6f, 0x1.ccbc34p-1f, 0x1.be9e6cp-2f},
    {-0x1.c363ccp+127f, -0x1.bff388p-1f, -0x1.efeaf8p-2f},
};

constexpr double kLeft = -1.3, kRight = 2.1, kBottom = -0.7, kTop = 0.9, kNear = 0.1, kFar = 9.7;

void expect_bits(const Matrix4& expected, const Matrix4& actual) {
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(std::bit_cast<std::uint32_t>(expected.m[i]), std::bit_cast<std::uint32_t>(actual.m[i]))
            << "element " << i << ": " << actual.m[i];
}

StackMatrix uniform() {
    StackMatrix stack;
    translate(stack, 1.1f, -2.3f, 0.7f);
    rotate(stack, 33, 1, 2, 3);
    scale(stack, 0.3f, 0.3f, 0.3f);
    return stack;
}

TEST(MatrixMath, Rotation) {
    expect_bits(kRotateGeneral, rotation(33, 1, 2, 3).value());
    expect_bits(kRotateY, rotation(-75, 0, -2, 0).value());
    EXPECT_FALSE(rotation(0, 1, 2, 3));
    EXPECT_FALSE(rotation(33, 0, 0, 0));
    EXPECT_FALSE(rotation(33, 5e-5f, 5e-5f, 0));
    EXPECT_TRUE(rotation(33, 1e-9f, 0, 0)) << "the length of a coordinate axis does not matter";
}

TEST(MatrixMath, Projections) {
    expect_bits(kOrtho, ortho(kLeft, kRight, kBottom, kTop, kNear, kFar));
    expect_bits(kFrustum, frustum(kLeft, kRight, kBottom, kTop, kNear, kFar));
}

TEST(MatrixMath, ProductsAndInversesFollowTheHistory) {
    StackMatrix stack = uniform();
    settle(stack);
    expect_bits(kUniform, stack.value);
    expect_bits(kUniformInverse, stack.inverse);

    scale(stack, 1, 2, 1.7f);
    settle(stack);
    expect_bits(kAffine, stack.value);
    expect_bits(kAffineInverse, stack.inverse);

    frustum(stack, kLeft, kRight, kBottom, kTop, kNear, kFar);
    settle(stack);
    expect_bits(kProjective, stack.value);
    expect_bits(kProjectiveInverse, stack.inverse);
}

TEST(MatrixMath, KindOfALoadedMatrixComesFromItsValues) {
    StackMatrix stack;
    load(stack, uniform().value);
    settle(stack);
    EXPECT_EQ(MatrixShape::k3d, stack.shape);
    EXPECT_TRUE(stack.traits & kUniformScale);
    EXPECT_FALSE(preserves_length(stack));

    load(stack, rotation(33, 1, 2, 3).value());
    settle(stack);
    EXPECT_TRUE(preserves_length(stack));

    load(stack, frustum(kLeft, kRight, kBottom, kTop, kNear, kFar));
    settle(stack);
    EXPECT_EQ(MatrixShape::kPerspective, stack.shape);
}

TEST(MatrixMath, IdentityKeepsTraits) {
    StackMatrix stack;
    frustum(stack, kLeft, kRight, kBottom, kTop, kNear, kFar);
    load_identity(stack);
    EXPECT_EQ(MatrixShape::kIdentity, stack.shape);
    rotate(stack, 33, 1, 2, 3);
    settle(stack);
    EXPECT_EQ(MatrixShape::kGeneral, stack.shape);
    EXPECT_FALSE(preserves_length(stack));
}

TEST(MatrixMath, SingularInverseIsTheIdentity) {
    StackMatrix stack;
    rotate(stack, 33, 1, 2, 3);
    scale(stack, 1, 0, 1);
    settle(stack);
    EXPECT_TRUE(stack.traits & kSingular);
    expect_bits(identity(), stack.inverse);
}

TEST(MatrixMath, TransposeAndRowProduct) {
    expect_bits(kAffine, transpose(transpose(kAffine)));
    const float v[4] = {1, -2, 3, -4};
    float row[4];
    transform_row(row, v, kAffine);
    const Matrix4 t = transpose(kAffine);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(t.at(i, 0) * v[0] + t.at(i, 1) * v[1] + t.at(i, 2) * v[2] + t.at(i, 3) * v[3], row[i]);
}

TEST(Sine, EqualsGlibc) {
    for (const SineCase& c : kSines) {
        EXPECT_EQ(std::bit_cast<std::uint32_t>(c.sine), std::bit_cast<std::uint32_t>(simd::sine(c.radians)))
            << c.radians;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(c.cosine),
                  std::bit_cast<std::uint32_t>(simd::cosine(c.radians)))
            << c.radians;
    }
    EXPECT_TRUE(std::isnan(simd::sine(INFINITY)));
    EXPECT_TRUE(std::isnan(simd::cosine(NAN)));
}

}  // namespace
}  // namespace terrazzo::gl
