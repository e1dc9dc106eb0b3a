#include "core/base/caught_error.h"

#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <typeinfo>

namespace vybeg {
namespace {

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
