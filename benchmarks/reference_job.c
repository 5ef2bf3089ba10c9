/* The reference job by hand: motor - (gap, spring) - sensor - (spring) - load; twelve motor harmonics of orders 6..72 by
   rotation of one sine, Stribeck friction at the load, sampled PI with current lag, Runge-Kutta 4, four steps a sample. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define H 12
static double ac[H], as[H];
static const double J1 = 1.5e-4, J2 = 7e-4, J3 = 2e-3, k1 = 450.0, c1 = 0.08, half = 5e-4, k2 = 940.0, c2 = 0.1;
static const double Tc = 0.3, Ts = 0.5, ws = 1.0, sm = 0.02, visc = 0.01, lag = 1.0 / (2 * M_PI * 500.0);
static double sensor;

static void slope(const double *x, double cmd, double *d) {
    double z = cos(6 * x[0]), y = sin(6 * x[0]), zr = z, yr = y, ripple = 0;
    for (int i = 0; i < H; i++) {
        ripple += ac[i] * zr - as[i] * yr;
        double t = zr * z - yr * y;
        yr = yr * z + zr * y;
        zr = t;
    }
    double twist = x[0] - x[1], rate = x[3] - x[4], t1 = 0;
    if (twist > half) { double p = k1 * (twist - half); t1 = fmax(0, p + fmin(p, c1 * rate)); }
    else if (twist < -half) { double p = k1 * (twist + half); t1 = fmin(0, p + fmax(p, c1 * rate)); }
    double t2 = k2 * (x[1] - x[2]) + c2 * (x[4] - x[5]);
    sensor = t2;
    double w = x[5], s = w / ws, grip = Tc + (fabs(s) < 6 ? (Ts - Tc) * exp(-s * s) : 0), dir = w / sm;
    double friction = grip * (dir > 20 ? 1 : dir < -20 ? -1 : tanh(dir)) + visc * w;
    d[0] = x[3]; d[1] = x[4]; d[2] = x[5];
    d[3] = (x[6] + ripple - t1) / J1;
    d[4] = (t1 - t2) / J2;
    d[5] = (t2 - friction) / J3;
    d[6] = (cmd - x[6]) / lag;
}

int main(int argc, char **argv) {
    double seconds = atof(argv[1]), speed = atof(argv[2]);
    for (int i = 0; i < H; i++) { double a = 0.02 / (i + 1), p = 0.3 * i; ac[i] = a * cos(p); as[i] = a * sin(p); }
    double x[7] = {0, 0, 0, speed, speed, speed, 0}, integral = 0, kp = 0.05, ki = 0.5, period = 1 / 25000.0, h = period / 4;
    long n = (long)(seconds * 25000);
    float *kept = malloc(n * sizeof(float));
    clock_t start = clock();
    for (long i = 0; i < n; i++) {
        double e = speed - x[3], wish = kp * e + ki * (integral + e * period), cmd = wish;
        if (fabs(wish) <= 2.0) integral += e * period; else cmd = wish > 0 ? 2.0 : -2.0;
        for (int step = 0; step < 4; step++) {
            double a[7], b[7], c[7], d[7], y[7];
            slope(x, cmd, a);
            if (step == 0) kept[i] = (float)sensor;
            for (int j = 0; j < 7; j++) y[j] = x[j] + 0.5 * h * a[j];
            slope(y, cmd, b);
            for (int j = 0; j < 7; j++) y[j] = x[j] + 0.5 * h * b[j];
            slope(y, cmd, c);
            for (int j = 0; j < 7; j++) y[j] = x[j] + h * c[j];
            slope(y, cmd, d);
            for (int j = 0; j < 7; j++) x[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
        }
    }
    double cpu = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%.6f %.12f %.9f\n", cpu, x[5], kept[n - 1]);
    return 0;
}
