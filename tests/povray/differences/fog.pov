// A black wall in white fog.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
fog { distance 5 rgb 1 }
plane { -z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
