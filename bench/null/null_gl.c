// A GL that does nothing, so that the time that a tool takes to replay a trace is known without a driver.
// Every exported function is there and returns 0; those below answer so that the tool goes on.
#include <stddef.h>

#define EXPORT __attribute__((visibility("default")))

#define NOTHING(name)        \
    EXPORT long name(void);  \
    EXPORT long name(void) { \
        return 0;            \
    }
#include "null_names.h"

// What a mapped buffer is to be, however large it should be.
static char s_mapped[64 << 20];
enum { kVendor = 0x1f00, kRenderer = 0x1f01, kVersion = 0x1f02, kBufferSize = 0x8764 };

EXPORT const char* glGetString(unsigned name);
EXPORT const char* glGetString(unsigned name) {
    return name == kVersion ? "2.1 null" : name == kVendor || name == kRenderer ? "null" : "";
}
EXPORT void* glMapBuffer(unsigned target, unsigned access);
EXPORT void* glMapBuffer(unsigned target, unsigned access) {
    return (void)target, (void)access, s_mapped;
}
EXPORT void* glMapBufferARB(unsigned target, unsigned access);
EXPORT void* glMapBufferARB(unsigned target, unsigned access) {
    return glMapBuffer(target, access);
}
EXPORT void* glMapBufferRange(unsigned target, ptrdiff_t offset, ptrdiff_t length, unsigned access);
EXPORT void* glMapBufferRange(unsigned target, ptrdiff_t offset, ptrdiff_t length, unsigned access) {
    return (void)offset, (void)length, glMapBuffer(target, access);
}
EXPORT void glGetBufferParameteriv(unsigned target, unsigned name, int* value);
EXPORT void glGetBufferParameteriv(unsigned target, unsigned name, int* value) {
    (void)target;
    *value = name == kBufferSize ? (int)sizeof s_mapped : 0;
}
EXPORT void glGetBufferParameterivARB(unsigned target, unsigned name, int* value);
EXPORT void glGetBufferParameterivARB(unsigned target, unsigned name, int* value) {
    glGetBufferParameteriv(target, name, value);
}
