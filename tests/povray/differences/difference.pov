// A glowing ball with a hollow.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
difference {
    sphere { 0, 1 }
    cylinder { -2*z, 2*z, 0.5 }
    pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }
}
