// expect rmse 1e-3: single pixels on the edges of a pattern fall to the other side by rounding
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 2.2, -5> look_at <0, 0.3, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { brick rgb 0.8 rgb <0.7,0.2,0.1> scale 0.1 } }
sphere { <-0.8, 0.8, 0>, 0.7 pigment { brick rgb 0.6 rgb <0.6,0.3,0.2> brick_size <0.5,0.2,0.3> mortar 0.03 scale 0.9 } }
box { <0.2, 0.1, -0.5>, <1.3, 1.2, 0.5> rotate 20*y pigment { brick pigment { rgb 0.9 } pigment { rgb <0.2,0.3,0.6> } mortar 0.1 scale 0.08 rotate 10 } }
