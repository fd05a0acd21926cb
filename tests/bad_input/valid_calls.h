// One call with good arguments for every command that can refuse some: what is spoiled, one argument at a
// time, by the tests of bad input.
#pragma once

#include <string>
#include <vector>

#include "gl/generated/calls.h"

namespace terrazzo::test {

// Argument lists hold numbers and these two kinds of pointers.
struct Buffer {};   // zeros, to be read
struct Names {};    // ones, to be read: a texture's name, or a count
struct Scratch {};  // to be written

struct Argument {
    enum class Kind { kInteger, kReal, kBuffer, kNames, kScratch };

    Argument(int value) : integer(value) {}
    Argument(unsigned value) : integer(value) {}
    Argument(double value) : kind(Kind::kReal), real(value) {}
    Argument(Buffer) : kind(Kind::kBuffer) {}
    Argument(Names) : kind(Kind::kNames) {}
    Argument(Scratch) : kind(Kind::kScratch) {}

    Kind kind = Kind::kInteger;
    long long integer = 0;
    double real = 0;
};

struct ValidCall {
    std::string names;  // a regular expression over the exported functions
    std::vector<Argument> arguments;
};

const std::vector<ValidCall>& valid_calls();

// The good arguments of a function, as many as it has; null when it is not in the list.
const std::vector<Argument>* valid_arguments(const std::string& name);

}  // namespace terrazzo::test
