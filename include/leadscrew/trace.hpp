#pragma once
/// \file
/// Words as CSV and NPY, out and in.

#include <leadscrew/trace/csv_writer.hpp>
#include <leadscrew/trace/formats.hpp>
#include <leadscrew/trace/npy_writer.hpp>
#include <leadscrew/trace/rows.hpp>
#include <leadscrew/trace/trace_reader.hpp>
#include <leadscrew/trace/writer.hpp>
