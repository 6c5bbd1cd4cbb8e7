SetFactory("OpenCASCADE");
DefineConstant[
  width = {100, Name "plate/width"},
  h = {40, Name "plate/size"}
];
Macro Corner
  Point(n) = {x, y, 0, h};
Return
For n In {1:3}
  x = (n - 1) * width / 2; y = 0;
  Call Corner;
EndFor
For n In {4:6}
  x = (6 - n) * width / 2; y = 100;
  Call Corner;
EndFor
For i In {1:5}
  Line(i) = {i, i + 1};
EndFor
Line(6) = {6, 1}; Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7}; Plane Surface(2) = {2};
If(width > 10)
  Physical Surface("material:concrete", 1) = {1};
EndIf
Physical Surface("material:concrete/right", 2) = {2};
Physical Curve("interface:crack", 3) = {7};
Physical Curve("boundary:left", 4) = {6};
Physical Curve("boundary:right", 5) = {3};
Physical Point("gauge:corner", 6) = {3};
