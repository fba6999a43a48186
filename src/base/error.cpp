// SPDX-License-Identifier: MIT
#include "base/error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "base/text.hpp"

namespace talus {
namespace {

std::string join(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_string(d);
  }
  return text;
}

/// Describes a failed file operation; errno distinguishes failures of the disk from wrong paths.
Failure describe_files(const std::filesystem::filesystem_error& error) {
  const std::error_code& reason = error.code();
  const bool is_disk = reason == std::errc::no_space_on_device || reason == std::errc::read_only_file_system ||
                       reason == std::errc::file_too_large || reason == std::errc::io_error;
  return {is_disk ? ExitCode::cannot_write : ExitCode::wrong_input,
          fmt::format("cannot use '{}': {}", error.path1().string(), reason.message())};
}

Failure describe_system(const std::system_error& error) {
  if (error.code() == std::errc::resource_unavailable_try_again)
    return {ExitCode::no_memory, "the machine starts no more threads"};
  return {ExitCode::cannot_write, fmt::format("cannot write: {}", error.code().message())};
}

}  // namespace

Failure explain_failure(const std::exception_ptr& thrown) {
  const auto defect = [](const std::string& what) {
    return Failure{ExitCode::internal_error,
                   fmt::format("internal error{}; please report it with the case file", what)};
  };
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return {error.code(), error.what()};
  } catch (const std::bad_alloc&) {
    return {ExitCode::no_memory, "the machine has not enough free memory; larger elements or fewer threads need less"};
  } catch (const std::filesystem::filesystem_error& error) {
    return describe_files(error);
  } catch (const std::system_error& error) {
    return describe_system(error);
  } catch (const std::exception& error) {
    return defect(fmt::format(": {}", error.what()));
  } catch (...) {
    return defect(" of unknown kind");
  }
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : Error(ExitCode::wrong_input, join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

std::string to_string(const Diagnostic& d) {
  const std::string sentence = make_printable(d.sentence, true);  // a zero byte would end the sentence
  if (d.line > 0) return fmt::format("{}:{}:{}: error: {}", d.file, d.line, d.column, sentence);
  if (!d.file.empty()) return fmt::format("{}: error: {}", d.file, sentence);
  return fmt::format("error: {}", sentence);
}

}  // namespace talus
