#pragma once
// A program on a controller, ready to be pulled: what check, path and run have in common.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/options.hpp"
#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"
#include "execute/watched.hpp"
#include "toolpath/toolpath.hpp"

namespace kerf {

/// Interpreter and toolpath passes over one program. Not movable: the toolpath points to the interpreter.
class Job {
 public:
  Job(const Controller& controller, std::shared_ptr<const Source> source)
      : interpreter_(controller.rules, std::move(source), controller.interpreter_options),
        programmed_(interpreter_),
        toolpath_(programmed_, controller.machine, controller.toolpath_policy) {}
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  const Action* next() { return toolpath_.next(); }
  /// After an alarm: go on with the next block.
  void recover() { toolpath_.recover(); }
  /// Shows the observer every action as the program has it, before the toolpath's passes.
  void watch_programmed(std::function<void(const Action&)> observer) {
    programmed_.watch(std::move(observer));
  }
  const Interpreter& interpreter() const { return interpreter_; }
  /// The text an action came from: the program itself or one it called.
  std::shared_ptr<const Source> source_of(const Action& action) const {
    return interpreter_.source_of(action.origin.program);
  }

 private:
  Interpreter interpreter_;
  Watched<Interpreter> programmed_;
  Toolpath<Watched<Interpreter>> toolpath_;
};

/// What a command needs before it can make a Job.
struct Prepared {
  std::shared_ptr<const Source> source;
  Controller controller;
};

/// Reads program and machine file. On failure the errors are on standard error and nothing is returned; what
/// is wrong with the program is in `why` too, if given.
std::optional<Prepared> prepare(const std::string& file, const CommonOptions& options,
                                std::string* why = nullptr);

/// The controller alone: for commands without a program, or the one that a program of that name and that
/// beginning gets.
std::optional<Controller> prepare_controller(const CommonOptions& options, std::string_view program = {},
                                             std::string_view text = {});

/// What a file begins with, enough to tell its dialect; empty when it cannot be read.
std::string beginning_of(const std::string& file);

/// Prints an alarm or a warning on standard error when the action is one, with the text of the program it
/// came from.
void print_alarm(const Action& action, const Job& job, const CommonOptions& options);

/// The share of the program read when an action came, 0 to 1.
double share_read(const Source& source, const Action& action);

}  // namespace kerf
