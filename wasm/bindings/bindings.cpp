// A table from the calls of web/src/solver/module.ts to the core. This folder alone knows of the
// web.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <string>
#include <vector>

#include "elimination.h"
#include "inertial_prediction.h"
#include "matrix_in_order.h"
#include "mistaken_simulation.h"
#include "ordering.h"
#include "simulation.h"
#include "solving_example.h"
#include "symplectic_euler.h"
#include "system_matrix_terms.h"
#include "triplets_from_matrix.h"
#include "values.h"

using namespace mass_spring;
using emscripten::val;

namespace {

std::string code(const Status& status) {
  return status_code_names()[static_cast<int>(status.code)];
}
// embind wants a way in for every field; a status only goes out.
void set_code(Status&, const std::string&) {}

std::string storage(const Parameters& parameters) {
  return parameters.storage == Storage::dense ? "dense" : "sparse";
}
void set_storage(Parameters& parameters, const std::string& name) {
  parameters.storage = name == "dense" ? Storage::dense : Storage::sparse;
}

std::string path(const Parameters& parameters) {
  return parameters.path == Path::fast ? "fast" : "plain";
}
void set_path(Parameters& parameters, const std::string& name) {
  parameters.path = name == "fast" ? Path::fast : Path::plain;
}

const std::string& method(const Parameters& parameters) {
  return method_names()[static_cast<int>(parameters.method)];
}

Method method_of(const std::string& name) { return named<Method>(name, method_names()); }
void set_method(Parameters& parameters, const std::string& name) {
  parameters.method = method_of(name);
}

std::string stop_reason(const Simulation& simulation) {
  const auto& outcome = simulation.outcome();
  return outcome ? stop_reason_names()[static_cast<int>(outcome->reason)] : "";
}

val compare(Simulation& simulation, const std::string& method, int iterations) {
  std::vector<double> rows;
  const Status status = simulation.compare(method_of(method), iterations, rows);
  val object = val::object();
  object.set("status", status);
  object.set("rows", copy("Float64Array", rows));
  return object;
}

/// What the forces at p^t would make of it.
val explicit_step(const TimeStep& step) {
  Points p;
  SymplecticEuler()(step, p);
  return copy("Float64Array", p);
}

val matrix(int rows, int columns, const Triplets& triplets) {
  std::vector<int> i, j;
  std::vector<double> value;
  for (const auto& entry : triplets) {
    i.push_back(entry.row());
    j.push_back(entry.col());
    value.push_back(entry.value());
  }
  val object = val::object();
  object.set("rows", rows);
  object.set("columns", columns);
  object.set("i", copy("Int32Array", i));
  object.set("j", copy("Int32Array", j));
  object.set("value", copy("Float64Array", value));
  return object;
}

val matrix(const SparseMatrix& sparse) {
  return matrix(sparse.rows(), sparse.cols(), triplets_from_matrix(sparse));
}

val terms_of_Q(const Simulation& simulation) {
  const SystemMatrixTerms terms = mass_spring::system_matrix_terms(simulation.time_step());
  val object = val::object();
  object.set("AtA", matrix(terms.AtA));
  object.set("springs", matrix(terms.springs));
  object.set("masses", matrix(terms.masses));
  object.set("pins", matrix(terms.pins));
  return object;
}

val terms_of_linearly_implicit(const Simulation& simulation) {
  const LinearlyImplicitTerms terms = simulation.linearly_implicit_terms();
  val object = val::object();
  object.set("K", matrix(terms.K));
  object.set("D", matrix(terms.D));
  object.set("P", matrix(terms.P));
  object.set("system", matrix(terms.system));
  object.set("constrained", matrix(terms.constrained));
  return object;
}

std::vector<int> order(const Simulation& simulation, const std::string& ordering) {
  return ordered_unknowns(named<Ordering>(ordering, ordering_names()), simulation.Q(),
                          simulation.order());
}

// Whoever asked for one of these two deletes it.
Elimination* elimination(const Simulation& simulation, const std::string& ordering) {
  return new Elimination(simulation.Q(), order(simulation, ordering));
}
SolvingExample* solving_example(const Simulation& simulation) {
  return new SolvingExample(matrix_in_order(simulation.Q(), order(simulation, "natural")));
}

val after(const Elimination& elimination, int columns) {
  std::vector<EliminatedEntry> entries;
  const Status status = elimination.after(columns, entries);
  Triplets triplets;
  std::vector<int> born;
  for (const auto& entry : entries) {
    triplets.emplace_back(entry.row, entry.column, entry.value);
    born.push_back(entry.born);
  }
  const int n = elimination.order().size();
  val object = matrix(n, n, triplets);
  object.set("born", copy("Int32Array", born));
  object.set("status", status);
  return object;
}

val probe(Simulation& simulation, int i) {
  const VertexProbe parts = simulation.probe_vertex(i);
  val object = val::object();
  object.set("y", val::array(parts.y.begin(), parts.y.end()));
  object.set("kAtd", val::array(parts.kAtd.begin(), parts.kAtd.end()));
  object.set("b", val::array(parts.b.begin(), parts.b.end()));
  object.set("Qp", val::array(parts.Qp.begin(), parts.Qp.end()));
  object.set("springs", copy("Int32Array", parts.springs));
  object.set("shares", copy("Float64Array", parts.shares));
  return object;
}

int vertices(const Simulation& simulation) { return simulation.time_step().p_curr.rows(); }
int springs(const Simulation& simulation) { return simulation.time_step().E.rows(); }
int pins(const Simulation& simulation) { return simulation.time_step().pinned.size(); }

val status_codes() { return val::array(status_code_names()); }
val methods() { return val::array(method_names()); }
val orderings() { return val::array(ordering_names()); }
val mistakes() { return val::array(mistake_names()); }

}  // namespace

EMSCRIPTEN_BINDINGS(solver) {
  using namespace emscripten;

  function("status_codes", &status_codes);
  function("methods", &methods);
  function("orderings", &orderings);
  function("mistakes", &mistakes);

  value_object<Status>("Status")
      .field("code", &code, &set_code)
      .field("field", &Status::field)
      .field("index", &Status::index)
      .field("value", &Status::value)
      .field("limit", &Status::limit);

  value_object<Parameters>("Parameters")
      .field("k", &Parameters::k)
      .field("delta_t", &Parameters::delta_t)
      .field("w", &Parameters::w)
      .field("mass_scale", &Parameters::mass_scale)
      .field("iterations", &Parameters::iterations)
      .field("method", &method, &set_method)
      .field("stop_gradient", &Parameters::stop_gradient)
      .field("stop_decrease", &Parameters::stop_decrease)
      .field("gravity", &Parameters::gravity)
      .field("damping", &Parameters::damping)
      .field("wind", &Parameters::wind)
      .field("path", &path, &set_path)
      .field("storage", &storage, &set_storage);

  value_object<Objective>("Objective")
      .field("objective", &Objective::objective)
      .field("potential", &Objective::potential)
      .field("inertia", &Objective::inertia)
      .field("external", &Objective::external)
      .field("pin", &Objective::pin)
      .field("damping", &Objective::damping)
      .field("pull", &Objective::pull);

  value_object<MechanicalEnergy>("MechanicalEnergy")
      .field("kinetic", &MechanicalEnergy::kinetic)
      .field("springs", &MechanicalEnergy::springs)
      .field("external", &MechanicalEnergy::external);

  using S = Simulation;
  class_<S>("Simulation")
      .constructor<>()
      .function(
          "set_progress",
          +[](S& s, val report) {
            s.set_progress(
                [report](const std::string& stage, double fraction) { report(stage, fraction); });
          })
      .function(
          "set_scene",
          +[](S& s, val V, val E, val m, val pinned, const Parameters& parameters) {
            return s.set_scene(doubles(V), ints(E), doubles(m), ints(pinned), parameters);
          })
      .function("set_parameters", &S::set_parameters)
      .function(
          "set_pins",
          +[](S& s, val pinned, val targets) { return s.set_pins(ints(pinned), doubles(targets)); })
      .function(
          "set_pull", +[](S& s, val vertices, val targets,
                          double k) { return s.set_pull(ints(vertices), doubles(targets), k); })
      .function("reset", &S::reset)
      .function(
          "set_state",
          +[](S& s, int step, val p_curr, val p_prev, int half_step) {
            return s.set_state(step, doubles(p_curr), doubles(p_prev), half_step);
          })
      .function("step", &S::step)
      .function("seek", &S::seek)
      .function("next_step", &S::next_step)
      .function("previous_step", &S::previous_step)
      .function("back_to", &S::back_to)
      .function("remembered_steps", &S::remembered_steps)
      .function("step_number", &S::step_number)
      .function("half_step", &S::half_step)
      .function("last_half_step", &S::last_half_step)
      .function("stop_reason", &stop_reason)
      .function("compare", &compare)
      .function("rehearse_local_step", &S::rehearse_local_step)
      .function("rehearse_global_step", &S::rehearse_global_step)
      .function("vertex_count", &vertices)
      .function("spring_count", &springs)
      .function(
          "p", +[](const S& s) { return lend(s.iterate().p); })
      .function(
          "p_before", +[](const S& s) { return lend(s.iterate().p_before); })
      .function(
          "p_curr", +[](const S& s) { return lend(s.time_step().p_curr); })
      .function(
          "p_prev", +[](const S& s) { return lend(s.time_step().p_prev); })
      .function(
          "inertial_prediction",
          +[](const S& s) { return copy("Float64Array", inertial_prediction(s.time_step())); })
      .function(
          "explicit_step", +[](const S& s) { return explicit_step(s.time_step()); })
      .function(
          "d", +[](const S& s) { return lend(s.iterate().d); })
      .function(
          "r", +[](const S& s) { return lend(s.time_step().r); })
      .function(
          "m", +[](const S& s) { return lend(s.time_step().m); })
      .function(
          "targets", +[](const S& s) { return lend(s.time_step().targets); })
      .function(
          "trace", +[](const S& s) { return lend(s.trace().rows()); })
      .function("probe_vertex", &probe)
      .function("energy", &S::energy)
      .function(
          "velocity", +[](const S& s) { return copy("Float64Array", s.velocity()); })
      .function("largest_frequency", &S::frequency)
      .function("stability_limit", &S::stability_limit)
      .function("stiffness_number", &S::stiffness_number)
      .function("factorisation_count", &S::factorisation_count)
      .function("factorisation_reason", &S::factorisation_reason)
      .function(
          "A", +[](const S& s) { return matrix(springs(s), vertices(s), s.A()); })
      .function(
          "M", +[](const S& s) { return matrix(vertices(s), vertices(s), s.M()); })
      .function(
          "C", +[](const S& s) { return matrix(pins(s), vertices(s), s.C()); })
      .function(
          "Q", +[](const S& s) { return matrix(vertices(s), vertices(s), s.Q()); })
      .function("system_matrix_terms", &terms_of_Q)
      .function(
          "settled", +[](const S& s) { return lend(s.settled()); })
      .function("linearly_implicit_terms", &terms_of_linearly_implicit)
      .function(
          "spring_stiffness",
          +[](const S& s, int e) { return copy("Float64Array", s.spring_stiffness(e)); })
      .function(
          "spring_resistance",
          +[](const S& s, int e) { return copy("Float64Array", s.spring_resistance(e)); })
      .function(
          "order",
          +[](const S& s, const std::string& ordering) {
            return copy("Int32Array", order(s, ordering));
          })
      .function("elimination", &elimination, allow_raw_pointers())
      .function("solving_example", &solving_example, allow_raw_pointers())
      .function(
          "y", +[](S& s) { return lend(s.y()); })
      .function(
          "objective_at", +[](const S& s, val p) { return s.objective_at(doubles(p)); })
      .function(
          "gradient_at",
          +[](const S& s, val p) { return copy("Float64Array", s.gradient_at(doubles(p))); });

  using E = Elimination;
  class_<E>("Elimination")
      .function(
          "order", +[](const E& e) { return copy("Int32Array", e.order()); })
      .function(
          "parent", +[](const E& e) { return copy("Int32Array", e.tree().parent); })
      .function(
          "height", +[](const E& e) { return copy("Int32Array", e.tree().height); })
      .function(
          "nonzeros", +[](const E& e) { return static_cast<double>(e.tree().nonzeros); })
      .function(
          "nonzeros_of_Q", +[](const E& e) { return static_cast<double>(e.nonzeros_of_Q()); })
      .function(
          "fill", +[](const E& e) { return static_cast<double>(e.fill()); })
      .function("flops", &E::flops)
      .function(
          "most_flops", +[](const E&) { return E::most_flops; })
      .function("factorise", &E::factorise)
      .function("after", &after);

  using F = MistakenSimulation;
  class_<F>("MistakenSimulation")
      .constructor<>()
      .function(
          "set_scene",
          +[](F& s, val V, val E, val m, val pinned, const Parameters& parameters,
              const std::string& mistake) {
            return s.set_scene(doubles(V), ints(E), doubles(m), ints(pinned), parameters,
                               named<Mistake>(mistake, mistake_names()));
          })
      .function("set_parameters", &F::set_parameters)
      .function(
          "set_pins",
          +[](F& s, val pinned, val targets) { return s.set_pins(ints(pinned), doubles(targets)); })
      .function("reset", &F::reset)
      .function(
          "set_state",
          +[](F& s, int step, val p_curr, val p_prev, int half_step) {
            return s.set_state(step, doubles(p_curr), doubles(p_prev), half_step);
          })
      .function("step", &F::step)
      .function("step_number", &F::step_number)
      .function("half_step", &F::half_step)
      .function("last_half_step", &F::last_half_step)
      .function(
          "vertex_count", +[](const F& s) { return static_cast<int>(s.time_step().m.size()); })
      .function(
          "spring_count", +[](const F& s) { return static_cast<int>(s.time_step().E.rows()); })
      .function(
          "p", +[](const F& s) { return lend(s.p()); })
      .function(
          "p_curr", +[](const F& s) { return lend(s.time_step().p_curr); })
      .function(
          "p_prev", +[](const F& s) { return lend(s.time_step().p_prev); })
      .function(
          "r", +[](const F& s) { return lend(s.time_step().r); })
      .function(
          "m", +[](const F& s) { return lend(s.time_step().m); })
      .function(
          "objective_at", +[](const F& s, val p) { return s.objective_at(doubles(p)); })
      .function("energy", &F::energy)
      .function(
          "factorisation_count", +[](const F& s) { return s.solver().factorisation_count(); })
      .function(
          "factorisation_time", +[](const F& s) { return s.solver().factorisation_time(); })
      .function(
          "stored_in_Q", +[](const F& s) { return s.solver().stored_in_Q(); })
      .function(
          "nonzeros_of_Q", +[](const F& s) { return s.solver().nonzeros_of_Q(); })
      .function("stored_in_L", +[](const F& s) { return s.solver().stored_in_L(); });

  class_<SolvingExample>("SolvingExample")
      .constructor<int>()
      .function("vertex_count", &SolvingExample::vertex_count)
      .function("dense_inverse", &SolvingExample::dense_inverse)
      .function("dense_factorise", &SolvingExample::dense_factorise)
      .function("dense_substitute", &SolvingExample::dense_substitute)
      .function("sparse_factorise", &SolvingExample::sparse_factorise)
      .function("sparse_substitute", &SolvingExample::sparse_substitute)
      .function("dense_bytes", &SolvingExample::dense_bytes)
      .function("sparse_matrix_bytes", &SolvingExample::sparse_matrix_bytes)
      .function("sparse_factor_bytes", &SolvingExample::sparse_factor_bytes)
      .function("residual", &SolvingExample::residual);
}
