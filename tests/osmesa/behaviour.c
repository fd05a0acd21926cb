/* Prints how a libOSMesa behaves, one fact per line. compare_libraries.py runs it with Terrazzo's library and with the
 * system's and wants the same lines.
 *
 * Uses clears only, so that every byte that is printed is determined by the interface. Pixels of 24 and 48 bits are
 * left out: Mesa 22.3 garbles them. So are colours that have no exact equal in 5, 6 and 5 bits where a clear is bounded
 * by the scissor, which Mesa draws with another rounding than whole clears. */
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const int kFormats[] = {OSMESA_RGBA, OSMESA_BGRA, OSMESA_ARGB, OSMESA_RGB, OSMESA_BGR, OSMESA_RGB_565,
                               OSMESA_COLOR_INDEX};
static const int kTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_UNSIGNED_SHORT_5_6_5, GL_BYTE, 0};
enum { kWidth = 5, kHeight = 3, kBytes = 4096 };

static void print_bytes(const unsigned char* bytes, int count) {
    for (int i = 0; i < count; ++i) printf("%02x%s", bytes[i], i % 16 == 15 ? " " : "");
    printf("\n");
}

static void print_integers(const char* title) {
    static const int kNames[] = {OSMESA_WIDTH, OSMESA_HEIGHT, OSMESA_FORMAT, OSMESA_TYPE, OSMESA_ROW_LENGTH,
                                 OSMESA_Y_UP,  0x77};
    printf("%s:", title);
    for (int i = 0; i < 7; ++i) {
        GLint value = -7;
        OSMesaGetIntegerv(kNames[i], &value);
        printf(" %x", value);
    }
    printf("\n");
}

/* The bottom row gets one colour, the others another. */
static void clear_two_colours(void) {
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.25f, 0.5f, 0.75f, 0.4f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, kWidth, 1);
    glClearColor(1.0f, 0.5f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

static void formats_and_types(void) {
    for (int f = 0; f < 7; ++f) {
        for (int t = 0; t < 6; ++t) {
            OSMesaContext ctx = OSMesaCreateContext(kFormats[f], NULL);
            unsigned char* buffer = malloc(kBytes);
            memset(buffer, 0xcd, kBytes);
            const GLboolean made = ctx && OSMesaMakeCurrent(ctx, buffer, kTypes[t], kWidth, kHeight);
            printf("format %x type %x: context %d current %d\n", kFormats[f], kTypes[t], ctx != NULL, made);
            if (made) {
                print_integers("  integers");
                clear_two_colours();
                print_bytes(buffer, 16); /* untouched until the flush */
                glFlush();
                const int garbled = kFormats[f] == OSMESA_RGB && kTypes[t] != GL_FLOAT;
                if (!garbled) print_bytes(buffer, kWidth * kHeight * 16 + 16);
                printf("  error %x\n", glGetError());
            }
            OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
            OSMesaDestroyContext(ctx);
            free(buffer);
        }
    }
}

static void rows(GLenum format, GLenum type) {
    unsigned char buffer[kBytes];
    OSMesaContext ctx = OSMesaCreateContext(format, NULL);
    OSMesaMakeCurrent(ctx, buffer, type, kWidth, kHeight);
    for (int y_up = 0; y_up < 2; ++y_up) {
        for (int length = 0; length < 9; length += 8) {
            memset(buffer, 0xcd, kBytes);
            OSMesaPixelStore(OSMESA_Y_UP, y_up);
            OSMesaPixelStore(OSMESA_ROW_LENGTH, length);
            OSMesaPixelStore(0x77, 1);
            print_integers("rows");
            clear_two_colours();
            glFinish();
            print_bytes(buffer, 8 * kHeight * 16 + 16);
        }
    }
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    OSMesaDestroyContext(ctx);
}

static void print_viewport(const char* title) {
    GLint viewport[4], scissor[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    printf("%s: viewport %d %d %d %d scissor %d %d %d %d\n", title, viewport[0], viewport[1], viewport[2], viewport[3],
           scissor[0], scissor[1], scissor[2], scissor[3]);
}

static void making_current(void) {
    static unsigned char first[kBytes], second[kBytes];
    OSMesaContext ctx = OSMesaCreateContext(OSMESA_RGBA, NULL);
    OSMesaContext other = OSMesaCreateContext(OSMESA_RGBA, ctx);
    printf("refused: %d %d %d %d %d\n", OSMesaMakeCurrent(ctx, NULL, GL_UNSIGNED_BYTE, 4, 4),
           OSMesaMakeCurrent(NULL, first, GL_UNSIGNED_BYTE, 4, 4), OSMesaMakeCurrent(ctx, first, GL_UNSIGNED_BYTE, 0, 4),
           OSMesaMakeCurrent(ctx, first, GL_UNSIGNED_BYTE, 4, -1), OSMesaMakeCurrent(ctx, first, GL_INT, 4, 4));
    printf("current: %d\n", OSMesaGetCurrentContext() != NULL);
    OSMesaMakeCurrent(ctx, first, GL_UNSIGNED_BYTE, kWidth, kHeight);
    printf("current: %d\n", OSMesaGetCurrentContext() == ctx);
    print_viewport("first");
    clear_two_colours();
    glFinish();

    /* The same size: the picture stays, and goes to the new buffer. */
    printf("again: %d\n", OSMesaMakeCurrent(ctx, second, GL_UNSIGNED_BYTE, kWidth, kHeight));
    glFinish();
    print_bytes(second, kWidth * kHeight * 4);

    /* Another size: the viewport stays. A call that is refused changes nothing. */
    printf("bigger: %d\n", OSMesaMakeCurrent(ctx, second, GL_UNSIGNED_BYTE, 2 * kWidth, 2 * kHeight));
    print_viewport("bigger");
    print_integers("bigger");
    clear_two_colours();
    glFinish();
    print_bytes(second, 4 * kWidth * kHeight * 4);
    printf("refused: %d\n", OSMesaMakeCurrent(ctx, second, GL_INT, 1, 1));
    print_integers("refused");

    /* Other types on the same context. */
    printf("float: %d\n", OSMesaMakeCurrent(ctx, second, GL_FLOAT, kWidth, kHeight));
    print_integers("float");
    clear_two_colours();
    glFinish();
    print_bytes(second, kWidth * kHeight * 16);
    glClearColor(2.5f, -1.0f, 0.5f, 1.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    print_bytes(second, 32);

    /* Two contexts take turns. */
    memset(first, 0, kBytes);
    memset(second, 0, kBytes);
    OSMesaMakeCurrent(other, first, GL_UNSIGNED_BYTE, 2, 2);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    OSMesaMakeCurrent(ctx, second, GL_UNSIGNED_BYTE, 2, 2);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    OSMesaMakeCurrent(other, first, GL_UNSIGNED_BYTE, 2, 2);
    glFinish();
    print_bytes(first, 32);
    print_bytes(second, 32);

    /* A picture that was not flushed reaches the buffer when the context is let go, not when it changes buffers. */
    clear_two_colours();
    OSMesaMakeCurrent(ctx, second, GL_UNSIGNED_BYTE, 2, 2);
    print_bytes(first, 32);
    print_bytes(second, 32);
    OSMesaMakeCurrent(other, first, GL_UNSIGNED_BYTE, 2, 2);
    memset(first, 0, kBytes);
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    OSMesaMakeCurrent(other, second, GL_UNSIGNED_BYTE, 2, 2);
    print_bytes(first, 32);
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    print_bytes(second, 32);
    OSMesaMakeCurrent(other, second, GL_UNSIGNED_BYTE, 2, 2);

    /* What was shown is not shown again. */
    memset(second, 0xcd, kBytes);
    glFlush();
    print_bytes(second, 32);
    glFinish();
    print_bytes(second, 32);
    glClear(GL_DEPTH_BUFFER_BIT);
    glFlush();
    print_bytes(second, 32);

    /* Destroying the current context. */
    OSMesaDestroyContext(other);
    printf("destroyed: current %d\n", OSMesaGetCurrentContext() == other);
    glClear(GL_COLOR_BUFFER_BIT);
    printf("error %x\n", glGetError());
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    printf("released: current %d\n", OSMesaGetCurrentContext() != NULL);
    OSMesaDestroyContext(ctx);
    OSMesaDestroyContext(NULL);
}

static void buffers(int depth_bits, int stencil_bits) {
    static unsigned char colour[kBytes];
    OSMesaContext ctx = OSMesaCreateContextExt(OSMESA_RGBA, depth_bits, stencil_bits, 0, NULL);
    printf("depth %d stencil %d: %d\n", depth_bits, stencil_bits, ctx != NULL);
    if (!ctx) return;
    GLint width = -1, height = -1, format = -1;
    void* buffer = colour;
    printf("  colour before: %d", OSMesaGetColorBuffer(ctx, &width, &height, &format, &buffer));
    printf(" %d %d %x %d\n", width, height, format, buffer != NULL);
    OSMesaMakeCurrent(ctx, colour, GL_UNSIGNED_BYTE, kWidth, kHeight);
    GLint bits[2] = {-1, -1};
    glGetIntegerv(GL_DEPTH_BITS, &bits[0]);
    glGetIntegerv(GL_STENCIL_BITS, &bits[1]);
    printf("  bits %d %d\n", bits[0], bits[1]);
    printf("  colour: %d", OSMesaGetColorBuffer(ctx, &width, &height, &format, &buffer));
    printf(" %d %d %x %d\n", width, height, format, buffer == colour);

    glClearDepth(0.25);
    glClearStencil(0x5a);
    clear_two_colours();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, kWidth, 1);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glFinish();
    GLint bytes = -1;
    const GLboolean got = OSMesaGetDepthBuffer(ctx, &width, &height, &bytes, &buffer);
    printf("  depth buffer: %d %d %d %d\n", got, width, height, bytes);
    if (got) {
        /* Of 4 bytes the highest is stencil, or nobody's. */
        for (int i = 0; i < width * height * bytes; ++i) {
            if (bytes != 4 || i % 4 != 3 || bits[1] > 0) printf("%02x", ((unsigned char*)buffer)[i]);
        }
        printf("\n");
        glClearDepth(0.5);
        glClear(GL_DEPTH_BUFFER_BIT);
        void* again = NULL;
        printf("  before the flush %02x", ((unsigned char*)buffer)[1]);
        glFinish();
        printf(", after it %02x", ((unsigned char*)buffer)[1]);
        OSMesaGetDepthBuffer(ctx, &width, &height, &bytes, &again);
        printf(", the same memory: %d\n", again == buffer);
    }
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    OSMesaDestroyContext(ctx);
}

static void attributes(void) {
    static const int kLists[][9] = {
        {0},
        {OSMESA_FORMAT, OSMESA_BGRA, 0},
        {OSMESA_FORMAT, 0x1234, 0},
        {OSMESA_DEPTH_BITS, -1, 0},
        {OSMESA_DEPTH_BITS, 8, 0},
        {OSMESA_DEPTH_BITS, 32, OSMESA_STENCIL_BITS, 8, OSMESA_ACCUM_BITS, 16, 0},
        {OSMESA_STENCIL_BITS, -1, 0},
        {OSMESA_ACCUM_BITS, -1, 0},
        {OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0},
        {OSMESA_PROFILE, 0x99, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 0, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 0, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 9, 0},
        {OSMESA_CONTEXT_MINOR_VERSION, -1, 0},
        {0x5678, 1, 0},
    };
    for (unsigned i = 0; i < sizeof kLists / sizeof *kLists; ++i) {
        OSMesaContext ctx = OSMesaCreateContextAttribs(kLists[i], NULL);
        printf("attributes %u: %d\n", i, ctx != NULL);
        if (!ctx) continue;
        static unsigned char colour[kBytes];
        OSMesaMakeCurrent(ctx, colour, GL_UNSIGNED_BYTE, kWidth, kHeight);
        print_integers("  integers");
        static const GLenum kBits[] = {GL_RED_BITS, GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS, GL_DOUBLEBUFFER};
        for (int b = 0; b < 5; ++b) {
            GLint value = -1;
            glGetIntegerv(kBits[b], &value);
            printf(" %d", value);
        }
        printf("\n");
        OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
        OSMesaDestroyContext(ctx);
    }
}

static void addresses(void) {
    static const char* const kNames[] = {"OSMesaCreateContext",  "OSMesaPostprocess", "OSMesaGetProcAddress",
                                         "glVertex3f",           "glGetError",        "OSMesaNoSuchFunction", ""};
    for (int i = 0; i < 7; ++i) printf("address of %s: %d\n", kNames[i], OSMesaGetProcAddress(kNames[i]) != NULL);
    printf("the same address: %d\n", OSMesaGetProcAddress("OSMesaDestroyContext") == (OSMESAproc)OSMesaDestroyContext);
}

int main(void) {
    printf("no context: current %d, error %x, string %d\n", OSMesaGetCurrentContext() != NULL, glGetError(),
           glGetString(GL_VERSION) != NULL);
    formats_and_types();
    rows(OSMESA_RGBA, GL_UNSIGNED_BYTE);
    rows(OSMESA_BGRA, GL_UNSIGNED_BYTE);
    rows(OSMESA_ARGB, GL_UNSIGNED_BYTE);
    rows(OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5);
    rows(OSMESA_RGBA, GL_UNSIGNED_SHORT);
    rows(OSMESA_ARGB, GL_UNSIGNED_SHORT);
    rows(OSMESA_RGBA, GL_FLOAT);
    rows(OSMESA_BGRA, GL_FLOAT);
    rows(OSMESA_RGB, GL_FLOAT);
    making_current();
    static const int kDepths[] = {-1, 0, 8, 16, 24, 32};
    for (int d = 0; d < 6; ++d) {
        for (int stencil = 0; stencil < 9; stencil += 8) buffers(kDepths[d], stencil);
    }
    attributes();
    addresses();
    return 0;
}
