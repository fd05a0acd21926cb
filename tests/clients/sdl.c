/* An SDL program that draws with SDL's renderer "opengl": rectangles, lines, points, textures with tints,
 * turned and mirrored, blend modes, a clip rectangle, triangles. SDL finds the library. usage: sdl glx|egl
 * PICTURE. Exits with 77 when SDL has no display. */
#include <SDL.h>
#include <SDL_opengl.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWidth = 320, kHeight = 240 };

static SDL_Texture* make_texture(SDL_Renderer* renderer) {
    static Uint32 texels[32][32];
    for (Uint32 y = 0; y < 32; ++y)
        for (Uint32 x = 0; x < 32; ++x)
            texels[y][x] =
                (128 + x * 4) << 24 | (x * 8) << 16 | (y * 8) << 8 | ((x / 4 + y / 4) % 2 ? 255 : 60);
    SDL_Texture* const texture =
        SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STATIC, 32, 32);
    SDL_UpdateTexture(texture, NULL, texels, sizeof texels[0]);
    return texture;
}

static void draw_shapes(SDL_Renderer* renderer) {
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_NONE);
    for (int i = 0; i < 6; ++i) {
        const SDL_Rect filled = {10 + 50 * i, 10, 40, 30}, outlined = {12 + 50 * i, 45, 36, 20};
        SDL_SetRenderDrawColor(renderer, (Uint8)(40 * i), (Uint8)(255 - 30 * i), 128, 255);
        SDL_RenderFillRect(renderer, &filled);
        SDL_RenderDrawRect(renderer, &outlined);
        SDL_RenderDrawLine(renderer, 10 + 8 * i, 230, 60 + 12 * i, 80);
        for (int k = 0; k < 10; ++k) SDL_RenderDrawPoint(renderer, 150 + 3 * k, 75 + 3 * i);
    }
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    SDL_SetRenderDrawColor(renderer, 250, 60, 20, 100);
    const SDL_FRect half_seen = {30.5F, 20.5F, 200, 50};
    SDL_RenderFillRectF(renderer, &half_seen);
}

static void draw_textures(SDL_Renderer* renderer, SDL_Texture* texture) {
    const SDL_Rect part = {4, 4, 20, 20}, plain = {180, 100, 64, 64}, scaled = {250, 100, 60, 40};
    const SDL_Rect turned = {100, 150, 60, 60}, clip = {200, 180, 100, 40}, large = {180, 150, 140, 90};
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
    SDL_RenderCopy(renderer, texture, NULL, &plain);
    SDL_SetTextureColorMod(texture, 255, 120, 200);
    SDL_SetTextureScaleMode(texture, SDL_ScaleModeLinear);
    SDL_RenderCopy(renderer, texture, &part, &scaled);
    SDL_SetTextureAlphaMod(texture, 180);
    SDL_RenderCopyEx(renderer, texture, NULL, &turned, 27, NULL, SDL_FLIP_HORIZONTAL);
    SDL_RenderSetClipRect(renderer, &clip);
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_ADD);
    SDL_RenderCopy(renderer, texture, NULL, &large);
    SDL_RenderSetClipRect(renderer, NULL);
}

static void draw_triangles(SDL_Renderer* renderer) {
    const SDL_Vertex corners[] = {{{20, 220}, {255, 0, 0, 255}, {0, 0}},
                                  {{90, 230}, {0, 255, 0, 255}, {0, 0}},
                                  {{60, 100}, {0, 0, 255, 128}, {0, 0}},
                                  {{130, 90}, {255, 255, 0, 200}, {0, 0}}};
    const int order[] = {0, 1, 2, 1, 3, 2};
    SDL_RenderGeometry(renderer, NULL, corners, 4, order, 6);
}

static int hand_over(SDL_Renderer* renderer, const char* path) {
    static unsigned char pixels[kHeight][kWidth][3];
    if (SDL_RenderReadPixels(renderer, NULL, SDL_PIXELFORMAT_RGB24, pixels, sizeof pixels[0]) != 0)
        return EXIT_FAILURE;
    void* const address = SDL_GL_GetProcAddress("glGetString");
    const GLubyte*(APIENTRY * get_string)(GLenum);
    SDL_memcpy(&get_string, &address, sizeof address);
    printf("renderer: %s\n", (const char*)get_string(GL_RENDERER));
    FILE* const file = fopen(path, "wb");
    if (!file) return EXIT_FAILURE;
    fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
    fwrite(pixels, sizeof pixels, 1, file);
    return fclose(file) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int count, char** arguments) {
    if (count != 3) return EXIT_FAILURE;
    SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, SDL_strcmp(arguments[1], "egl") == 0 ? "1" : "0");
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "opengl");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        printf("no SDL: %s\n", SDL_GetError());
        return 77;
    }
    SDL_Window* const window = SDL_CreateWindow("Terrazzo", 0, 0, kWidth, kHeight, SDL_WINDOW_OPENGL);
    SDL_Renderer* const renderer = window ? SDL_CreateRenderer(window, -1, 0) : NULL;
    SDL_RendererInfo information = {0};
    if (!renderer || SDL_GetRendererInfo(renderer, &information) != 0 ||
        SDL_strcmp(information.name, "opengl") != 0) {
        fprintf(stderr, "SDL's renderer is \"%s\": %s\n", information.name ? information.name : "none",
                SDL_GetError());
        return EXIT_FAILURE;
    }
    SDL_Texture* const texture = make_texture(renderer);
    int status = EXIT_FAILURE;
    for (int frame = 0; frame < 2; ++frame) {
        SDL_SetRenderDrawColor(renderer, 30, 40, 60, 255);
        SDL_RenderClear(renderer);
        draw_shapes(renderer);
        SDL_SetTextureColorMod(texture, 255, 255, 255);
        SDL_SetTextureAlphaMod(texture, 255);
        draw_textures(renderer, texture);
        draw_triangles(renderer);
        if (frame == 1) status = hand_over(renderer, arguments[2]);
        SDL_RenderPresent(renderer);
    }
    SDL_DestroyTexture(texture);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return status;
}
