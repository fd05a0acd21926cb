/* A program that was linked with Debian's -lOSMesa and knows nothing of Terrazzo. usage: offscreen PICTURE */
#include <GL/osmesa.h>

#define GL(name) gl##name
#include "picture.h"

int main(int count, char** arguments) {
    static unsigned char pixels[kPictureHeight][kPictureWidth][4];
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    if (count != 2 || !context) return EXIT_FAILURE;
    if (!OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kPictureWidth, kPictureHeight))
        return EXIT_FAILURE;
    draw_picture();
    glFinish();
    const int status = hand_over(arguments[1], &pixels[0][0][0]);
    OSMesaDestroyContext(context);
    return status;
}
