#pragma once
// Results as JSON, by the schemas of the command-line contract.

#include <initializer_list>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/interpolator/thread_figures.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/results/figures.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::results {

using json::Json;

inline constexpr std::string_view run_schema = "leadscrew.run/1";
inline constexpr std::string_view runs_schema = "leadscrew.runs/1";  ///< of several programs, whatever the verb
inline constexpr std::string_view check_schema = "leadscrew.check/1";
inline constexpr std::string_view verify_schema = "leadscrew.verify/1";
inline constexpr std::string_view drive_schema = "leadscrew.drive/1";

/// For what got no further than its diagnostics: {schema, program, machine, diagnostics}. `machine` may be empty.
Json json_of_rejected(std::string_view schema, const std::string& program, const std::string& machine,
                      const Diagnostics& diagnostics);

/// The list of them, as it stands under "diagnostics".
Json json_of_diagnostics(const Diagnostics& diagnostics);

/// Adds to an object that has the number of a line what else identifies its block: `file` and `visit`, where they are not 0.
void put_file_and_visit(Json& json, base::Line line);
/// `threads`: of lines in step with the machine's simulated spindle.
void add_threads(Json& json, const interpolator::ThreadFigures& threads);

/// `tip`, of the tool's tip and its direction, where tool centre point control was.
void add_tip(Json& json, const referee::Verdict& verdict);
/// What run and simulate say alike of a program that has been moved through: {schema … dwell_s}, and then `more`.
Json json_of_motion(std::string_view schema, const std::string& program, const machine::Machine& machine,
                    const pipeline::Summary& summary, std::initializer_list<Json::Member> more);
Json json_of_run(const std::string& program, const machine::Machine& machine, const RunFigures& figures,
                 const Diagnostics& diagnostics);
Json json_of_check(const std::string& program, const machine::Machine& machine, const CheckFigures& reading,
                   const Diagnostics& diagnostics);
Json json_of_verify(const std::string& program, const machine::Machine& machine, const VerifyFigures& figures,
                    const Diagnostics& diagnostics);

/// The one object that goes to standard output: that of the program, or of several, by a schema of their own, {schema,
/// programs: […]}.
std::string json_text(std::string_view schema, std::vector<Json> objects);

}  // namespace leadscrew::results
