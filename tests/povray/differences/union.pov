// A union of overlapping balls with one interior: POV-Ray takes the second entry for a leave.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-5 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
plane { -z, -4 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate -4*x } finish { ambient 0 diffuse 0 emission 1 } }
union {
    sphere { -0.3*x, 0.7 }
    sphere { 0.3*x, 0.7 }
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior 1.3 }
}
