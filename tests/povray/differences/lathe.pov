// A turned ring, as bright as it is far away, along a ray that rises by a millionth: to POV-Ray its two sides fall together midway.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z direction <0, 1e-6, 1> right 1e-9*x up 1e-9*y }
lathe {
    linear_spline 5, <0.2, -1>, <1, -1>, <0.9, 1>, <0.2, 1>, <0.2, -1>
    pigment { gradient z color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate -5*z } finish { ambient 0 diffuse 0 emission 1 }
}
