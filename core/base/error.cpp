#include "core/base/error.h"

#include <array>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

namespace vybeg {
namespace {

// Exit statuses (help, files.html).
constexpr int wrong_call = 2;
constexpr int bad_input = 3;
constexpr int impossible = 4;
constexpr int no_output = 5;
constexpr int stopped = 130;

// Its type and its text: either may say nothing by itself.
Error program_fault(const std::exception& error) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> type(
        abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), &std::free);
    return {ErrorCode::program_fault,
            {},
            {std::string(status == 0 ? type.get() : typeid(error).name()) + ": " + error.what()}};
}

}  // namespace

MessageRow message_row(ErrorCode code) {
    static constexpr std::array rows{
#define ROW(code, status, sentence) MessageRow{#code, status, sentence},
#include "core/base/error_rows.h"
#undef ROW
    };
    return row_at(rows, static_cast<std::size_t>(code));
}

std::string code_name(ErrorCode code) {
    return message_row(code).name();
}

int exit_status(ErrorCode code) {
    return message_row(code).grade;
}

std::vector<MessageArg> message_args(const Error& error) {
    std::vector<MessageArg> args{error.where};
    args.insert(args.end(), error.args.begin(), error.args.end());
    return args;
}

std::string english(const Error& error) {
    return english(message_row(error.code), message_args(error));
}

Error error_of(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return {ErrorCode::out_of_memory, {}, {}};
    } catch (const std::length_error&) {
        return {ErrorCode::out_of_memory, {}, {}};  // more than the address space holds
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::resource_unavailable_try_again) {
            return {ErrorCode::out_of_threads, {}, {}};
        }
        return program_fault(error);
    } catch (const std::runtime_error& error) {
        if (typeid(error) == typeid(std::runtime_error)) {
            return {ErrorCode::out_of_threads, {}, {}};  // oneTBB's, of pthread_create
        }
        return program_fault(error);
    } catch (const std::exception& error) {
        return program_fault(error);
    } catch (...) {
        return {ErrorCode::program_fault, {}, {"an exception without a text"}};
    }
}

}  // namespace vybeg
