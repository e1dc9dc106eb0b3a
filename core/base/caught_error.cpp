#include "core/base/caught_error.h"

#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

namespace vybeg {

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
        return {ErrorCode::program_fault, {}, {error.what()}};
    } catch (const std::runtime_error& error) {
        if (typeid(error) == typeid(std::runtime_error)) {
            return {ErrorCode::out_of_threads, {}, {}};  // oneTBB's, of pthread_create
        }
        return {ErrorCode::program_fault, {}, {error.what()}};
    } catch (const std::exception& error) {
        return {ErrorCode::program_fault, {}, {error.what()}};
    } catch (...) {
        return {ErrorCode::program_fault, {}, {"an exception without a text"}};
    }
}

}  // namespace vybeg
