// The calls of web/src/solver/inverse_kinematics.ts.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>

#include "inverse_kinematics.h"
#include "values.h"

using emscripten::val;

namespace {

/// @param task  an IkTask
val inverse_kinematics(const val& task) {
  kinematics::Task given;
  given.offsets = doubles(task["offsets"]);
  given.root = doubles(task["root"]);
  given.start = doubles(task["start"]);
  given.start_q = doubles(task["start_q"]);
  given.target = doubles(task["target"]);
  given.method =
      named<kinematics::Method>(task["method"].as<std::string>(), kinematics::method_names());
  given.settings = {task["iterations"].as<int>(), task["epsilon"].as<double>(),
                    task["turn_limit"].as<double>(), doubles(task["bend_limits"])};
  given.single_precision = task["precision"].as<std::string>() == "single";
  kinematics::Answer answer;
  const mass_spring::Status status = kinematics::inverse_kinematics(given, answer);
  val found = val::object();
  found.set("outcome", kinematics::outcome_names()[static_cast<int>(answer.outcome)]);
  found.set("iterations", answer.iterations);
  found.set("error", answer.error);
  found.set("start_x", copy("Float64Array", answer.start_x));
  found.set("start_q", copy("Float64Array", answer.start_q));
  found.set("x", copy("Float64Array", answer.x));
  found.set("q", copy("Float64Array", answer.q));
  found.set("errors", copy("Float64Array", answer.errors));
  found.set("events", copy("Int32Array", answer.events));
  found.set("event_x", copy("Float64Array", answer.event_x));
  found.set("event_q", copy("Float64Array", answer.event_q));
  val object = val::object();
  object.set("status", status);
  object.set("answer", found);
  return object;
}
val ik_outcomes() { return val::array(kinematics::outcome_names()); }
val ik_methods() { return val::array(kinematics::method_names()); }

}  // namespace

EMSCRIPTEN_BINDINGS(kinematics) {
  emscripten::function("inverse_kinematics", &inverse_kinematics);
  emscripten::function("ik_outcomes", &ik_outcomes);
  emscripten::function("ik_methods", &ik_methods);
}
