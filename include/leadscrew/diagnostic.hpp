#pragma once
/// \file
/// What is wrong, where, and what would be right; results that are either a value or that. Where bytes come from
/// and go to.

#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
