#pragma once
/// \file
/// A part program of any length, in constant memory: text in, words out, in one thread.

#include <leadscrew/pipeline/program.hpp>
