// SPDX-License-Identifier: MIT
#include <vtkCallbackCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "viz/picture.hpp"

namespace gno::viz {
namespace {

void sliderMoved(vtkObject* caller, unsigned long, void* data, void*) {
    auto& representation = *static_cast<vtkSliderRepresentation2D*>(static_cast<vtkSliderWidget*>(caller)->GetRepresentation());
    const int value = int(std::lround(representation.GetValue()));
    representation.SetValue(value);
    static_cast<const Slider*>(data)->moved(value);
}

void timeIsOver(vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkRenderWindowInteractor*>(caller)->TerminateApp(); }

vtkSmartPointer<vtkSliderRepresentation2D> representationOf(const Slider& slider) {
    const auto representation = vtkSmartPointer<vtkSliderRepresentation2D>::New();
    representation->SetMinimumValue(slider.least);
    representation->SetMaximumValue(slider.most);
    representation->SetValue(slider.start);
    representation->SetTitleText(slider.title.c_str());
    representation->SetLabelFormat("%.0f");
    representation->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    representation->GetPoint1Coordinate()->SetValue(0.6, 0.05);
    representation->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    representation->GetPoint2Coordinate()->SetValue(0.97, 0.05);
    for (vtkTextProperty* property : {representation->GetTitleProperty(), representation->GetLabelProperty()}) {
        property->SetColor(kDark.r, kDark.g, kDark.b);
        property->ShadowOff();
        property->BoldOff();
    }
    representation->GetTubeProperty()->SetColor(kPale.r, kPale.g, kPale.b);
    representation->GetSliderProperty()->SetColor(kBlue.r, kBlue.g, kBlue.b);
    return representation;
}

}  // namespace

void Picture::show(const Slider& slider, double closeAfter) {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window_);
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetInteractorStyle(style);
    vtkNew<vtkSliderWidget> widget;
    widget->SetInteractor(interactor);
    widget->SetRepresentation(representationOf(slider));
    widget->SetAnimationModeToJump();
    vtkNew<vtkCallbackCommand> moved;
    moved->SetCallback(sliderMoved);
    moved->SetClientData(const_cast<Slider*>(&slider));
    widget->AddObserver(vtkCommand::InteractionEvent, moved);
    widget->EnabledOn();
    render();
    interactor->Initialize();
    if (closeAfter > 0) {
        vtkNew<vtkCallbackCommand> over;
        over->SetCallback(timeIsOver);
        interactor->AddObserver(vtkCommand::TimerEvent, over);
        interactor->CreateOneShotTimer(static_cast<unsigned long>(1000 * closeAfter));
    }
    interactor->Start();
}

}  // namespace gno::viz
