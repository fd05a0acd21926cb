// The instruction sets of this build, for the tables that are made once per set.
// The build defines TERRAZZO_ISAS(X): X(name, enumerator) for each, best first, `scalar` last. `name` is also
// the set's namespace, isa_<name>; `enumerator` is simd::Isa's.
#pragma once

#include "simd/isa.h"

#ifndef TERRAZZO_ISAS
#error "TERRAZZO_ISAS is defined by src/simd/meson.build"
#endif
