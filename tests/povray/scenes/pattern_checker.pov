// expect rmse 1e-3: single pixels on the edges of a pattern fall to the other side by rounding
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 2.2, -5> look_at <0, 0.3, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb 1 rgb 0.2 scale 0.37 } }
sphere { <-0.8, 0.8, 0>, 0.7 pigment { checker rgb <1,0,0> rgb <0,0,1> scale 0.2 rotate 30*x } }
box { <0.2, 0.1, -0.5>, <1.3, 1.2, 0.5> rotate 20*y pigment { checker pigment { checker rgb 1 rgb 0 scale 0.2 } pigment { rgb <0.2,0.6,0.3> } scale 0.4 translate 0.1 } }
