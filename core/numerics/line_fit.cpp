#include "core/numerics/line_fit.h"

#include <cmath>
#include <cstddef>

namespace vybeg {

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    LineFit fit;
    double count = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (!std::isnan(x[k] + y[k])) {
            fit.mean_x += x[k];
            fit.mean_y += y[k];
            count += 1;
        }
    }
    fit.mean_x /= count;
    fit.mean_y /= count;
    double product = 0;
    double spread = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (!std::isnan(x[k] + y[k])) {
            product += (x[k] - fit.mean_x) * (y[k] - fit.mean_y);
            spread += (x[k] - fit.mean_x) * (x[k] - fit.mean_x);
        }
    }
    fit.slope = spread > 0 ? product / spread : 0;
    return fit;
}

}  // namespace vybeg
